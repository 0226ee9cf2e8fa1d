// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "orthoball/exact/double_double.h"

namespace orthoball {

/// pi to 106 bits.
inline constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// Turns lengths, areas or volumes from the scaled units of Sites into input units.
class InputUnits {
 public:
  /// @param power           1 for lengths, 2 for areas, 3 for volumes.
  /// @param scale_exponent  one unit of the points is 2^scale_exponent units of the values.
  /// @param decimals        one input unit is 10^decimals units of the points, >= 0.
  /// @param divisor         the values are this many times too large, 1..6.
  InputUnits(int power, int scale_exponent, int decimals, int divisor);

  /// The value in input units. Error <= (1/2 + 2^-40) units in the last place where `value` is
  /// exact and the result is a normal number; infinite beyond the double range.
  [[nodiscard]] double operator()(const DoubleDouble& value) const {
    const double product = has_factor_ ? (value * factor_).high : value.high;
    return power_of_two_ != 0.0 ? product * power_of_two_ : std::ldexp(product, exponent_);
  }

 private:
  DoubleDouble factor_;      // a value is to be multiplied by factor_ * 2^exponent_
  bool has_factor_ = false;  // factor_ is not 1
  int exponent_ = 0;
  double power_of_two_ = 1.0;  // 2^exponent_, 0 where that is no normal number
};

/// The other way, rounded: a number of input units as one of the scaled units of Sites. Infinite or
/// 0 beyond the double range.
/// @param power, scale_exponent, decimals  as above.
[[nodiscard]] double from_input_units(double value, int power, int scale_exponent, int decimals);

}  // namespace orthoball
