// SPDX-License-Identifier: MIT
//
// Why the rule is right. Lowering weights by eps raises the lifted sites. Seen from the query, the
// hyperplane through the lifted corners rises by sum lambda_i eps_i, the query itself by its own
// eps. There is a conflict where the plane ends above the query. The largest eps with a non-zero
// coefficient decides: positive for a corner with lambda_i > 0, negative for the query.
//
// lambda_i is a ratio of orientations: the simplex with corner i replaced by the query, over the
// simplex itself, which is positive. No site lies in the plane or line of the others' tie where
// this could vanish for all: the query has coefficient -1.
#include "orthoball/exact/perturbation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace orthoball {

template <int D>
bool precedes(const Sites<D>& sites, std::uint32_t a, std::uint32_t b) {
  // The first axis counts most. Without branches: which axis decides is hard to predict.
  const auto before = [](const double* p, const double* q) {
    unsigned less = 0, more = 0;
    for (int axis = 0; axis < D; ++axis) {
      less = 2 * less + (p[axis] < q[axis] ? 1 : 0);
      more = 2 * more + (p[axis] > q[axis] ? 1 : 0);
    }
    return less > more;
  };
  if (sites.is_exact()) return before(sites[a].x, sites[b].x);
  return before(sites.exact(a).x, sites.exact(b).x);
}

namespace {

// What stands between a query and the corners of a simplex, where that is so small, and integers,
// that positions compare as one double and determinants have no error.
template <int D>
class SmallTie {
 public:
  SmallTie(const Sites<D>& sites, const Corners<D>& corners, std::uint32_t query) {
    double sum = 0.0;  // not the largest, which would take branches
    for (std::size_t i = 0; i <= D; ++i) {
      keys_[i] = 0.0;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const double x = sites[corners[i]].x[axis] - sites[query].x[axis];
        rows_[i][axis] = x;
        keys_[i] = keys_[i] * kBase + x;
        sum += std::abs(x);
      }
    }
    is_small_ = sites.is_integral() && sum <= kBase / 4;
  }
  [[nodiscard]] bool is_small() const { return is_small_; }

  // Only if small.
  [[nodiscard]] bool conflicts() {
    for (std::size_t count = 0; count <= D; ++count) {
      std::size_t last = 0;
      for (std::size_t i = 1; i <= D; ++i) last = keys_[i] > keys_[last] ? i : last;
      if (keys_[last] < 0.0) return false;  // the query is later
      const double lambda = lambda_of(last);
      if (lambda != 0.0) return lambda > 0.0;
      keys_[last] = -std::numeric_limits<double>::infinity();
    }
    return false;
  }

 private:
  // Differences of up to a quarter are told apart as digits. D of them, and D! products of D, are
  // below 2^53.
  static constexpr double kBase = D == 3 ? 0x1p+17 : 0x1p+25;

  // The orientation with the query in the place of corner i: of (query, others) in an order that
  // makes (i, others) an even permutation.
  [[nodiscard]] double lambda_of(std::size_t i) const {
    if constexpr (D == 3) {
      const auto &a = rows_[i ^ 1U], &b = rows_[i ^ 2U], &c = rows_[i ^ 3U];
      return a[2] * (b[0] * c[1] - b[1] * c[0]) - b[2] * (a[0] * c[1] - a[1] * c[0]) +
             c[2] * (a[0] * b[1] - a[1] * b[0]);
    } else {
      const auto &a = rows_[(i + 1) % 3], &b = rows_[(i + 2) % 3];
      return a[0] * b[1] - a[1] * b[0];
    }
  }

  std::array<std::array<double, std::size_t{D}>, std::size_t{D + 1}> rows_;
  std::array<double, std::size_t{D + 1}> keys_;
  bool is_small_;
};

}  // namespace

template <int A, int D>
bool perturbed_conflict(const Sites<D>& sites, const Corners<A>& corners, std::uint32_t query) {
  if constexpr (A == D) {
    SmallTie<D> tie(sites, corners, query);
    if (tie.is_small()) return tie.conflicts();
  }
  std::array<std::uint32_t, std::size_t{A + 1}> left;  // corners not looked at yet
  for (std::uint32_t i = 0; i <= A; ++i) left[i] = i;
  for (std::size_t count = A + 1; count > 0; --count) {
    std::size_t last = 0;
    for (std::size_t j = 1; j < count; ++j) {
      last = precedes(sites, corners[left[last]], corners[left[j]]) ? j : last;
    }
    const std::uint32_t i = std::exchange(left[last], left[count - 1]);
    if (precedes(sites, corners[i], query)) return false;
    Corners<A> replaced = corners;
    replaced[i] = query;
    const Sign lambda = orient<A, D>(sites, replaced);
    if (lambda != Sign::zero) return lambda == Sign::positive;
  }
  return false;
}

template bool precedes<2>(const Sites<2>&, std::uint32_t, std::uint32_t);
template bool precedes<3>(const Sites<3>&, std::uint32_t, std::uint32_t);
template bool perturbed_conflict<1, 2>(const Sites<2>&, const Corners<1>&, std::uint32_t);
template bool perturbed_conflict<2, 2>(const Sites<2>&, const Corners<2>&, std::uint32_t);
template bool perturbed_conflict<1, 3>(const Sites<3>&, const Corners<1>&, std::uint32_t);
template bool perturbed_conflict<2, 3>(const Sites<3>&, const Corners<2>&, std::uint32_t);
template bool perturbed_conflict<3, 3>(const Sites<3>&, const Corners<3>&, std::uint32_t);

}  // namespace orthoball
