// SPDX-License-Identifier: MIT
#include "orthoball/exact/power_side.h"

#include <array>

#include "orthoball/exact/local_frame.h"

namespace orthoball {
namespace {

// One corner less the query: coordinates and lift.
template <class Int, int D>
struct LiftedSite {
  Int x[std::size_t{D}];
  Int lift;
};

template <class Int, int D>
LiftedSite<Int, D> lifted(const ExactSite<D>& site, const ExactSite<D>& query,
                          const LocalFrame& frame) {
  const auto p = integer_site<Int, D>(site, query, frame);
  const auto q = integer_site<Int, D>(query, query, frame);
  LiftedSite<Int, D> result;
  result.lift = q.weight - p.weight;
  for (int axis = 0; axis < D; ++axis) {
    result.x[axis] = p.x[axis];
    result.lift += p.x[axis] * p.x[axis];
  }
  return result;
}

template <class Int, int D>
Int minor2(const LiftedSite<Int, D>& a, const LiftedSite<Int, D>& b) {
  return a.x[0] * b.x[1] - a.x[1] * b.x[0];
}

template <class Int, int D>
Int minor3(const LiftedSite<Int, D>& a, const LiftedSite<Int, D>& b, const LiftedSite<Int, D>& c) {
  return a.x[2] * minor2(b, c) - b.x[2] * minor2(a, c) + c.x[2] * minor2(a, b);
}

// At most (A + 1)! 2^(A bits) times a lift of at most (D + 1) 2^(2 bits).
template <class Int, int A, int D>
Int lifted_determinant(const std::array<ExactSite<D>, std::size_t{A + 2}>& sites,
                       const LocalFrame& frame) {
  const auto row = [&](std::size_t i) { return lifted<Int, D>(sites[i], sites[A + 1], frame); };
  const auto a = row(0);
  const auto b = row(1);
  if constexpr (A == 1) {
    return a.lift * b.x[0] - b.lift * a.x[0];
  } else {
    const auto c = row(2);
    if constexpr (A == 2) {
      return a.lift * minor2(b, c) - b.lift * minor2(a, c) + c.lift * minor2(a, b);
    } else {
      const auto d = row(3);
      return a.lift * minor3(b, c, d) - b.lift * minor3(a, c, d) + c.lift * minor3(a, b, d) -
             d.lift * minor3(a, b, c);
    }
  }
}

}  // namespace

template <int A, int D>
Sign exact_power_side(const Sites<D>& sites, const Corners<A>& corners, std::uint32_t query) {
  std::array<ExactSite<D>, std::size_t{A + 2}> exact;
  for (std::size_t i = 0; i <= A; ++i) exact[i] = sites.exact(corners[i]);
  exact[A + 1] = sites.exact(query);
  // The frame's differences are to its first site, the determinant's to the last: one bit more.
  LocalFrame frame = local_frame<D>(exact);
  const int bits = (A + 2) * (frame.bits + 1) + 8;  // (A + 1)! (D + 1) < 2^8
  return with_width(
      bits, [&]<class Int>() { return lifted_determinant<Int, A, D>(exact, frame).sign(); });
}

template Sign exact_power_side<1, 2>(const Sites<2>&, const Corners<1>&, std::uint32_t);
template Sign exact_power_side<2, 2>(const Sites<2>&, const Corners<2>&, std::uint32_t);
template Sign exact_power_side<1, 3>(const Sites<3>&, const Corners<1>&, std::uint32_t);
template Sign exact_power_side<2, 3>(const Sites<3>&, const Corners<2>&, std::uint32_t);
template Sign exact_power_side<3, 3>(const Sites<3>&, const Corners<3>&, std::uint32_t);

}  // namespace orthoball
