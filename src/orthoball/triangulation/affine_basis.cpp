// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/affine_basis.h"

#include <algorithm>
#include <optional>

#include "orthoball/exact/orient.h"

namespace orthoball {
namespace {

// The first axes, in their order, on which the sites are independent; their lexicographic order is
// then that of positions too.
template <int A, int D>
std::optional<std::array<int, std::size_t{D}>> independent_axes(const Sites<D>& sites,
                                                                const Corners<A>& corners) {
  for (unsigned chosen = 0; chosen < 1U << D; ++chosen) {
    std::array<int, std::size_t{D}> axes{};
    std::size_t inside = 0;
    std::size_t outside = A;
    for (int axis = 0; axis < D; ++axis) {
      const bool taken = (chosen >> axis & 1U) != 0;
      if (taken ? inside == A : outside == D) break;
      axes[taken ? inside++ : outside++] = axis;
    }
    if (inside != A || outside != D) continue;
    std::array<int, std::size_t{A}> first;
    std::copy_n(axes.begin(), A, first.begin());
    if (exact_orient<A, D>(sites, corners, first) != Sign::zero) return axes;
  }
  return std::nullopt;
}

// Appends the first site in `order` that is independent of the A sites found so far.
template <int A, int D>
bool extend(AffineBasis<D>& basis, const Sites<D>& sites, std::span<const std::uint32_t> order) {
  if (basis.sites.size() != A) return false;
  Corners<A> corners;
  std::copy(basis.sites.begin(), basis.sites.end(), corners.begin());
  for (const std::uint32_t site : order) {
    corners[A] = site;
    if (const auto axes = independent_axes<A, D>(sites, corners)) {
      basis.sites.push_back(site);
      basis.axes = *axes;
      return true;
    }
  }
  return false;
}

}  // namespace

template <int D>
AffineBasis<D> affine_basis(const Sites<D>& sites, std::span<const std::uint32_t> order) {
  AffineBasis<D> basis;
  if (order.empty()) return basis;
  basis.sites.push_back(order[0]);
  extend<1>(basis, sites, order);
  extend<2>(basis, sites, order);
  if constexpr (D == 3) extend<3>(basis, sites, order);
  return basis;
}

template AffineBasis<2> affine_basis<2>(const Sites<2>&, std::span<const std::uint32_t>);
template AffineBasis<3> affine_basis<3>(const Sites<3>&, std::span<const std::uint32_t>);

}  // namespace orthoball
