// SPDX-License-Identifier: MIT
#include "orthoball/measures/input_units.h"

#include <cmath>

namespace orthoball {

InputUnits::InputUnits(int power, int scale_exponent, int decimals, int divisor) {
  // divisor * 10^(power decimals) * 2^(power scale_exponent), with 10^k = 5^k 2^k and a mantissa
  // kept near 1 so that no number of decimals overflows it.
  exponent_ = -power * (scale_exponent + decimals);
  for (; divisor % 2 == 0; divisor /= 2) --exponent_;
  DoubleDouble mantissa{static_cast<double>(divisor), 0.0};
  for (int i = 0; i < power * decimals; ++i) {
    mantissa = mantissa * ExactDouble{5.0};
    if (mantissa.high < 0x1p+100) continue;
    mantissa = {mantissa.high * 0x1p-100, mantissa.low * 0x1p-100};
    exponent_ -= 100;
  }
  factor_ = DoubleDouble{1.0, 0.0} / mantissa;
  has_factor_ = mantissa.high != 1.0;
  power_of_two_ = exponent_ >= -1000 && exponent_ <= 1000 ? std::ldexp(1.0, exponent_) : 0.0;
}

}  // namespace orthoball
