// SPDX-License-Identifier: MIT
#include "orthoball/exact/orient.h"

#include <array>

#include "orthoball/exact/local_frame.h"

namespace orthoball {
namespace {

// det of the rows 1..A, each a site less site 0; at most A! 2^(A bits).
template <class Int, int A, int D>
Int orientation(const std::array<ExactSite<D>, std::size_t{A + 1}>& sites,
                const LocalFrame& frame) {
  const auto row = [&](std::size_t i) { return integer_site<Int, D>(sites[i], sites[0], frame); };
  const auto b = row(1);
  if constexpr (A == 1) {
    return b.x[0];
  } else {
    const auto c = row(2);
    const Int bc = b.x[0] * c.x[1] - b.x[1] * c.x[0];
    if constexpr (A == 2) {
      return bc;
    } else {
      const auto d = row(3);
      return b.x[2] * (c.x[0] * d.x[1] - c.x[1] * d.x[0]) -
             c.x[2] * (b.x[0] * d.x[1] - b.x[1] * d.x[0]) + d.x[2] * bc;
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
  const int bits = A * (frame.bits + 1) + 4;  // A! < 2^4
  return with_width(bits, [&]<class Int>() { return orientation<Int, A, D>(exact, frame).sign(); });
}

template Sign exact_orient<1, 2>(const Sites<2>&, const Corners<1>&, const std::array<int, 1>&);
template Sign exact_orient<2, 2>(const Sites<2>&, const Corners<2>&, const std::array<int, 2>&);
template Sign exact_orient<1, 3>(const Sites<3>&, const Corners<1>&, const std::array<int, 1>&);
template Sign exact_orient<2, 3>(const Sites<3>&, const Corners<2>&, const std::array<int, 2>&);
template Sign exact_orient<3, 3>(const Sites<3>&, const Corners<3>&, const std::array<int, 3>&);

}  // namespace orthoball
