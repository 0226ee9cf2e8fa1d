// SPDX-License-Identifier: MIT
#include "orthoball/measures/input_units.h"

#include <cmath>

namespace orthoball {

InputUnits::InputUnits(int power, int scale_exponent, int decimals, int divisor) {
  // divisor * 10^(power decimals) * 2^(power scale_exponent), with 10^k = 5^k 2^k and a mantissa
  // kept near 1 so that no number of decimals overflows it.
  DoubleDouble mantissa{static_cast<double>(divisor), 0.0};
  exponent_ = -power * (scale_exponent + decimals);
  for (int i = 0; i < power * decimals; ++i) {
    mantissa = mantissa * ExactDouble{5.0};
    if (mantissa.high < 0x1p+100) continue;
    mantissa = {mantissa.high * 0x1p-100, mantissa.low * 0x1p-100};
    exponent_ -= 100;
  }
  factor_ = DoubleDouble{1.0, 0.0} / mantissa;
  power_of_two_ = exponent_ >= -1000 && exponent_ <= 1000 ? std::ldexp(1.0, exponent_) : 0.0;
}

double InputUnits::operator()(DoubleDouble value) const {
  const double product =
      factor_.high == 1.0 && factor_.low == 0.0 ? value.high : (value * factor_).high;
  return power_of_two_ != 0.0 ? product * power_of_two_ : std::ldexp(product, exponent_);
}

}  // namespace orthoball
