// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

namespace orthoball {

/// The angle of the vector (x, y), y >= 0, with the positive x axis: atan2(y, x), in [0, pi]
/// radians; 0 for the zero vector. Error <= 3 * 2^-53 times the larger of 1 and the angle.
///
/// Written without branches and without the C library so that compilers turn loops over it into
/// vector code and all machines give the same bits.
///
/// The vector is turned by a multiple of pi/4 into |angle| <= pi/8, where a polynomial of degree
/// 10 in z = u^2 is (atan(u)/u - 1) / z to 2^-57: interpolation at Chebyshev nodes, whose error
/// shrinks by (12.66 + sqrt(12.66^2 - 1)) = 25.3 a degree, for the nearest singularity z = -1 is
/// 12.66 half widths from the middle of [0, tan(pi/8)^2].
[[nodiscard]] inline double angle_from_x_axis(double x, double y) {
  constexpr double kTangentOfEighth = 0x1.a827999fcef32p-2;  // tan(pi/8) = sqrt(2) - 1
  constexpr double kQuarter = 0x1.921fb54442d18p-1, kQuarterLow = 0x1.1a62633145c07p-55;  // pi/4
  constexpr std::array<double, 11> kArctangent{
      -0x1.5555555555555p-2, 0x1.999999999934cp-3, -0x1.2492492436201p-3, 0x1.c71c71853d7fap-4,
      -0x1.745d0b28a7e37p-4, 0x1.3b1263064f6b9p-4, -0x1.10fa77b1a6d57p-4, 0x1.dfe6497e96323p-5,
      -0x1.a0999c632b6edp-5, 0x1.4162c02b1dda3p-5, -0x1.3a31b1c0fd3b7p-6};
  const double x_size = x < 0.0 ? -x : x;
  const double shorter = y <= x_size ? y : x_size;
  const double longer = y <= x_size ? x_size : y;
  const bool turned = shorter > kTangentOfEighth * longer;
  const double top = turned ? shorter - longer : shorter;
  const double sum = turned ? shorter + longer : longer;
  const double bottom = sum > 0.0 ? sum : 1.0;
  const double u = top / bottom;
  const double z = u * u;
  const double z2 = z * z;
  // Estrin's scheme: pairs, then a chain in z^2.
  double series = kArctangent[10];
  series = series * z2 + (kArctangent[8] + kArctangent[9] * z);
  series = series * z2 + (kArctangent[6] + kArctangent[7] * z);
  series = series * z2 + (kArctangent[4] + kArctangent[5] * z);
  series = series * z2 + (kArctangent[2] + kArctangent[3] * z);
  series = series * z2 + (kArctangent[0] + kArctangent[1] * z);
  const double small = u + u * (z * series);
  // Unfold: the angle with the nearer axis, then with the positive x axis, in quarters of pi.
  const double quarters = turned ? 1.0 : 0.0;
  const double from_axis_quarters = y <= x_size ? quarters : 2.0 - quarters;
  const double from_axis_small = y <= x_size ? small : -small;
  const double total_quarters = x < 0.0 ? 4.0 - from_axis_quarters : from_axis_quarters;
  const double total_small = x < 0.0 ? -from_axis_small : from_axis_small;
  return total_quarters * kQuarter + (total_quarters * kQuarterLow + total_small);
}

/// angles[i] = angle_from_x_axis(x[i], y[i]), all of the same length: many at once.
void angles_from_x_axis(std::span<const double> x, std::span<const double> y,
                        std::span<double> angles);

}  // namespace orthoball
