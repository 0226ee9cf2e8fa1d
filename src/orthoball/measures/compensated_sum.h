// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "orthoball/exact/double_double.h"
#include "orthoball/exact/error_free.h"

namespace orthoball {

/// A sum of finite doubles whose rounding errors are summed beside it: the result is as if it were
/// computed with 106 bits, error <= n^2 2^-106 times the sum of magnitudes for n terms.
///
/// Terms of at most 2^960 are summed; larger ones, of which a few could overflow, are only counted
/// (`large_count`), and then `value` is what the others give.  @cite ogita_rump_oishi_2005
class CompensatedSum {
 public:
  static constexpr double kLargestTerm = 0x1p+960;

  /// @param term  finite or +infinity, not below -kLargestTerm.
  void add(double term) {
    if (term > kLargestTerm) {
      ++large_count_;
      return;
    }
    const Exactly sum = two_sum(sum_, term);
    sum_ = sum.high;
    error_ += sum.low;
  }

  /// The sum; `high` is it rounded to a double.
  [[nodiscard]] DoubleDouble value() const {
    const Exactly sum = two_sum(sum_, error_);
    return {sum.high, sum.low};
  }
  /// Terms that were counted instead of summed.
  [[nodiscard]] std::uint64_t large_count() const { return large_count_; }

 private:
  double sum_ = 0.0;
  double error_ = 0.0;
  std::uint64_t large_count_ = 0;
};

}  // namespace orthoball
