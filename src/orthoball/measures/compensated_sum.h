// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/exact/double_double.h"
#include "orthoball/exact/error_free.h"

namespace orthoball {

/// A sum of doubles whose rounding errors are summed beside it: the result is as if it were
/// computed with 106 bits, error <= n^2 2^-106 times the sum of magnitudes for n terms.
/// @cite ogita_rump_oishi_2005
class CompensatedSum {
 public:
  /// @param term  finite; the terms must not overflow together.
  void add(double term) {
    const Exactly sum = two_sum(sum_, term);
    sum_ = sum.high;
    error_ += sum.low;
  }

  /// The sum; `high` is it rounded to a double.
  [[nodiscard]] DoubleDouble value() const {
    const Exactly sum = two_sum(sum_, error_);
    return {sum.high, sum.low};
  }

 private:
  double sum_ = 0.0;
  double error_ = 0.0;
};

}  // namespace orthoball
