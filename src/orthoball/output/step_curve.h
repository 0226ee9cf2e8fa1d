// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace orthoball {

/// What a step function does within one column of a picture.
struct StepColumn {
  double x;     ///< where its first step in the column is; in pixels
  double low;   ///< the smallest value it steps to
  double high;  ///< the largest
  double last;  ///< the value with which it leaves the column
};

/// A step function of any number of steps, reduced to what a picture can show: per column of half a
/// pixel the extremes and the last value. The drawing that results covers the same pixels as that
/// of all steps would.
///
/// Memory is that of the columns with a step in them, whatever the number of steps.
class StepCurve {
 public:
  /// @param width  of the picture in pixels; steps beyond it are left out, steps before 0 set the
  ///               value with which the picture begins.
  explicit StepCurve(double width) : width_(width) {}

  /// From `x` on the value is `value`. x must not decrease from call to call.
  void add(double x, double value);

  /// The value at the left edge, 0 if no step lies before it.
  [[nodiscard]] double initial() const { return initial_; }
  [[nodiscard]] std::span<const StepColumn> columns() const { return columns_; }
  /// The extremes over the whole picture.
  [[nodiscard]] double low() const;
  [[nodiscard]] double high() const;

 private:
  double width_;
  double initial_ = 0.0;
  std::vector<StepColumn> columns_;
};

}  // namespace orthoball
