// SPDX-License-Identifier: MIT
#include "orthoball/exact/orient.h"

#include <array>

#include "orthoball/exact/local_frame.h"

namespace orthoball {
namespace {

// det of the rows 1..A, each a site less site 0. Coordinates have N limbs, with two bits to spare;
// every product has the limbs of its factors, so sums of at most six terms fit.
template <int N, int A, int D>
Sign orientation(const std::array<ExactSite<D>, std::size_t{A + 1}>& sites,
                 const LocalFrame& frame) {
  using Int = WideInteger<N>;
  const auto row = [&](std::size_t i) { return integer_site<Int, D>(sites[i], sites[0], frame); };
  const auto b = row(1);
  if constexpr (A == 1) {
    return b.x[0].sign();
  } else {
    const auto minor = [](const auto& p, const auto& q) {
      return product(p.x[0], q.x[1]) - product(p.x[1], q.x[0]);
    };
    const auto c = row(2);
    if constexpr (A == 2) {
      return minor(b, c).sign();
    } else {
      const auto d = row(3);
      return (product(b.x[2], minor(c, d)) - product(c.x[2], minor(b, d)) +
              product(d.x[2], minor(b, c)))
          .sign();
    }
  }
}

}  // namespace

template <int A, int D>
Sign exact_orient(const Sites<D>& sites, const Corners<A>& corners,
                  const std::array<int, std::size_t{A}>& axes) {
  std::array<ExactSite<D>, std::size_t{A + 1}> exact{};  // without weights and other axes
  for (std::size_t i = 0; i <= A; ++i) {
    const ExactSite<D> site = sites.exact(corners[i]);
    for (std::size_t axis = 0; axis < A; ++axis) exact[i].x[axis] = site.x[axes[axis]];
  }
  const LocalFrame frame = local_frame<D>(exact);
  return with_limbs(frame.bits, [&]<int N>() { return orientation<N, A, D>(exact, frame); });
}

template Sign exact_orient<1, 2>(const Sites<2>&, const Corners<1>&, const std::array<int, 1>&);
template Sign exact_orient<2, 2>(const Sites<2>&, const Corners<2>&, const std::array<int, 2>&);
template Sign exact_orient<1, 3>(const Sites<3>&, const Corners<1>&, const std::array<int, 1>&);
template Sign exact_orient<2, 3>(const Sites<3>&, const Corners<2>&, const std::array<int, 2>&);
template Sign exact_orient<3, 3>(const Sites<3>&, const Corners<3>&, const std::array<int, 3>&);

}  // namespace orthoball
