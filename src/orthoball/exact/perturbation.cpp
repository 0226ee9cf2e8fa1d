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

template <int A, int D>
bool perturbed_conflict(const Sites<D>& sites, const Corners<A>& corners, std::uint32_t query) {
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
