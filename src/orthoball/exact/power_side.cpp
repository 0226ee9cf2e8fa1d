// SPDX-License-Identifier: MIT
#include "orthoball/exact/power_side.h"

#include <array>

#include "orthoball/exact/local_frame.h"

namespace orthoball {
namespace {

// One corner less the query: coordinates of N limbs, with two bits to spare, and the lift, whose
// sum of at most five terms fits twice as many.
template <int N, int D>
struct LiftedSite {
  WideInteger<N> x[std::size_t{D}];
  WideInteger<2 * N> lift;
};

template <int N, int D>
LiftedSite<N, D> lifted(const ExactSite<D>& site, const ExactSite<D>& query,
                        const LocalFrame& frame) {
  // Weights need twice the limbs.
  const auto p = integer_site<WideInteger<2 * N>, D>(site, query, frame);
  const auto q = integer_site<WideInteger<2 * N>, D>(query, query, frame);
  LiftedSite<N, D> result;
  result.lift = q.weight - p.weight;
  for (std::size_t axis = 0; axis < D; ++axis) {
    result.x[axis] = p.x[axis].template resized<N>();
    result.lift += product(result.x[axis], result.x[axis]);
  }
  return result;
}

template <class Site>
auto minor2(const Site& a, const Site& b) {
  return product(a.x[0], b.x[1]) - product(a.x[1], b.x[0]);
}

template <class Site>
auto minor3(const Site& a, const Site& b, const Site& c) {
  return product(a.x[2], minor2(b, c)) - product(b.x[2], minor2(a, c)) +
         product(c.x[2], minor2(a, b));
}

// det of the rows (lift, x). Every product has the limbs of its factors: with two bits to spare in
// each factor, sums of at most 24 terms fit.
template <int N, int A, int D>
Sign lifted_determinant(const std::array<ExactSite<D>, std::size_t{A + 2}>& sites,
                        const LocalFrame& frame) {
  const auto row = [&](std::size_t i) { return lifted<N, D>(sites[i], sites[0], frame); };
  const auto a = row(1);
  const auto b = row(2);
  if constexpr (A == 1) {
    return (product(a.lift, b.x[0]) - product(b.lift, a.x[0])).sign();
  } else {
    const auto c = row(3);
    if constexpr (A == 2) {
      return (product(a.lift, minor2(b, c)) - product(b.lift, minor2(a, c)) +
              product(c.lift, minor2(a, b)))
          .sign();
    } else {
      const auto d = row(4);
      return (product(a.lift, minor3(b, c, d)) - product(b.lift, minor3(a, c, d)) +
              product(c.lift, minor3(a, b, d)) - product(d.lift, minor3(a, b, c)))
          .sign();
    }
  }
}

}  // namespace

template <int A, int D>
Sign exact_power_side(const Sites<D>& sites, const Corners<A>& corners, std::uint32_t query) {
  std::array<ExactSite<D>, std::size_t{A + 2}> exact;
  exact[0] = sites.exact(query);
  for (std::size_t i = 0; i <= A; ++i) exact[i + 1] = sites.exact(corners[i]);
  const LocalFrame frame = local_frame<D>(exact);
  return with_limbs(frame.bits, [&]<int N>() { return lifted_determinant<N, A, D>(exact, frame); });
}

template Sign exact_power_side<1, 2>(const Sites<2>&, const Corners<1>&, std::uint32_t);
template Sign exact_power_side<2, 2>(const Sites<2>&, const Corners<2>&, std::uint32_t);
template Sign exact_power_side<1, 3>(const Sites<3>&, const Corners<1>&, std::uint32_t);
template Sign exact_power_side<2, 3>(const Sites<3>&, const Corners<2>&, std::uint32_t);
template Sign exact_power_side<3, 3>(const Sites<3>&, const Corners<3>&, std::uint32_t);

}  // namespace orthoball
