// SPDX-License-Identifier: MIT
#include "orthoball/measures/input_units.h"

#include <cmath>

namespace orthoball {

namespace {

// factor * 5^count = mantissa * 2^exponent, the mantissa kept small so that no count overflows it.
struct ScaledPower {
  DoubleDouble mantissa;
  int exponent = 0;
};

ScaledPower times_five_to(double factor, int count) {
  ScaledPower power{{factor, 0.0}, 0};
  for (int i = 0; i < count; ++i) {
    power.mantissa = power.mantissa * ExactDouble{5.0};
    if (power.mantissa.high < 0x1p+100) continue;
    power.mantissa = {power.mantissa.high * 0x1p-100, power.mantissa.low * 0x1p-100};
    power.exponent += 100;
  }
  return power;
}

}  // namespace

InputUnits::InputUnits(int power, int scale_exponent, int decimals, int divisor) {
  // divisor * 10^(power decimals) * 2^(power scale_exponent), with 10^k = 5^k 2^k.
  exponent_ = -power * (scale_exponent + decimals);
  for (; divisor % 2 == 0; divisor /= 2) --exponent_;
  const ScaledPower scaled = times_five_to(divisor, power * decimals);
  exponent_ -= scaled.exponent;
  factor_ = DoubleDouble{1.0, 0.0} / scaled.mantissa;
  has_factor_ = scaled.mantissa.high != 1.0;
  power_of_two_ = exponent_ >= -1000 && exponent_ <= 1000 ? std::ldexp(1.0, exponent_) : 0.0;
}

double from_input_units(double value, int power, int scale_exponent, int decimals) {
  const ScaledPower scaled = times_five_to(1.0, power * decimals);
  int exponent = 0;
  const DoubleDouble product = scaled.mantissa * ExactDouble{std::frexp(value, &exponent)};
  return std::ldexp(product.high, exponent + scaled.exponent + power * (scale_exponent + decimals));
}

}  // namespace orthoball
