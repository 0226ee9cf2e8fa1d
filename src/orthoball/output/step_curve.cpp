// SPDX-License-Identifier: MIT
#include "orthoball/output/step_curve.h"

#include <algorithm>
#include <cmath>

namespace orthoball {

void StepCurve::add(double x, double value) {
  if (!(x <= width_)) return;
  if (x <= 0.0) {
    initial_ = value;
    return;
  }
  const auto column = [](double pixel) { return std::floor(2.0 * pixel); };
  if (columns_.empty() || column(columns_.back().x) != column(x)) {
    columns_.push_back({x, value, value, value});
    return;
  }
  StepColumn& last = columns_.back();
  last.low = std::min(last.low, value);
  last.high = std::max(last.high, value);
  last.last = value;
}

double StepCurve::low() const {
  double low = initial_;
  for (const StepColumn& column : columns_) low = std::min(low, column.low);
  return low;
}

double StepCurve::high() const {
  double high = initial_;
  for (const StepColumn& column : columns_) high = std::max(high, column.high);
  return high;
}

}  // namespace orthoball
