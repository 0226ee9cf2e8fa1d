// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "orthoball/exact/double_double.h"
#include "orthoball/exact/error_free.h"
#include "orthoball/exact/processor.h"
#include "orthoball/exact/sites.h"
#include "orthoball/measures/angle.h"
#include "orthoball/measures/contributions.h"
#include "orthoball/measures/input_units.h"
#include "orthoball/measures/thin_cell.h"
#include "orthoball/topology/facet_roles.h"

/// The formulas of single simplices, over many at a time: the coordinates of kLanes of them are
/// laid out side by side, and every formula is a loop over the lanes without branches, which
/// compilers turn into vector code. Of contributions.cpp alone.
///
/// A tetrahedron with vertices a, b, c, d gives the cross products n_a, n_b, n_c, n_d of its facets
/// (n_a without a, and so on), each a product of differences from the facet's first vertex, so that
/// the same facet gives the same double from both sides. The angle at an edge between the outward
/// normals of its two facets, the exterior angle, has the cosine +-(n . m) / (|n| |m|) and the sine
/// |n x m| / (|n| |m|). As n x m is 6 V times the edge, its length is 6 V len, and the angle is
/// atan2(6 V len, +-(n . m)): the sign is the product of the signs that turn both outward. Where a
/// cross product is all rounding the cell is measured again with integers (thin_cell.h).
namespace orthoball::measure_lanes_detail {

inline constexpr std::size_t kLanes = 32;
struct alignas(64) Row : std::array<double, kLanes> {};
struct alignas(64) BitsRow : std::array<std::uint64_t, kLanes> {};

template <int D>
using Points = std::array<Row, static_cast<std::size_t>(D)>;  // [axis][lane]

/// N points per lane and the exponent of its results: lengths are to be multiplied by 2^exponent,
/// areas by 2^(2 exponent) and so on.
template <int D, std::size_t N>
struct Batch {
  std::array<Points<D>, N> x;
  std::array<int, kLanes> exponent;
};

struct Vector {
  double x, y, z;
};
[[gnu::always_inline]] inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline double norm(const Vector& a) { return std::sqrt(dot(a, a)); }
[[gnu::always_inline]] inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[gnu::always_inline]] inline Vector vector(const Points<3>& points, std::size_t lane) {
  return {points[0][lane], points[1][lane], points[2][lane]};
}
[[gnu::always_inline]] inline double length(const Points<2>& a, const Points<2>& b,
                                            std::size_t lane) {
  const double x = b[0][lane] - a[0][lane], y = b[1][lane] - a[1][lane];
  return std::sqrt(x * x + y * y);
}

/// pi x, rounded once: pi itself must not be, for such terms cancel against angles in sums.
[[gnu::always_inline]] inline double times_pi(double x) {
  const Exactly product = two_product(x, kPi.high);
  return product.high + (product.low + x * kPi.low);
}

template <std::size_t N>
using Vertices = std::array<std::uint32_t, N>;  // by number, ascending

/// The coordinates of all lanes, whether they are needed or not.
template <std::size_t N>
[[gnu::always_inline]] inline void load_lanes(const Site<2>* sites,
                                              const std::array<Vertices<N>, kLanes>& vertices,
                                              Batch<2, N>& batch) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    for (std::size_t i = 0; i < N; ++i) {
      const Site<2>& site = sites[vertices[lane][i]];
      batch.x[i][0][lane] = site.x[0];
      batch.x[i][1][lane] = site.x[1];
    }
  }
}
/// Four lanes at a time: four rows become four columns.
template <std::size_t N>
[[gnu::always_inline]] inline void load_lanes(const Site<3>* __restrict sites,
                                              const std::array<Vertices<N>, kLanes>& vertices,
                                              Batch<3, N>& __restrict batch) {
  using Four = double __attribute__((vector_size(32)));
  static_assert(sizeof(Site<3>) == sizeof(Four) && kLanes % 4 == 0);
  for (std::size_t lane = 0; lane < kLanes; lane += 4) {
    for (std::size_t i = 0; i < N; ++i) {
      std::array<Four, 4> site;
      for (std::size_t k = 0; k < 4; ++k) {
        std::memcpy(&site[k], &sites[vertices[lane + k][i]], sizeof(Four));
      }
      const Four ab_xz = __builtin_shufflevector(site[0], site[1], 0, 4, 2, 6);
      const Four ab_y = __builtin_shufflevector(site[0], site[1], 1, 5, 1, 5);
      const Four cd_xz = __builtin_shufflevector(site[2], site[3], 0, 4, 2, 6);
      const Four cd_y = __builtin_shufflevector(site[2], site[3], 1, 5, 1, 5);
      const Four x = __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5);
      const Four y = __builtin_shufflevector(ab_y, cd_y, 0, 1, 4, 5);
      const Four z = __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7);
      std::memcpy(&batch.x[i][0][lane], &x, sizeof x);
      std::memcpy(&batch.x[i][1][lane], &y, sizeof y);
      std::memcpy(&batch.x[i][2][lane], &z, sizeof z);
    }
  }
}

/// What the formulas give, lane by lane. Facets are numbered by the corner opposite.
template <int D>
struct CellRows {
  Row volume, length;
  Row excess;  ///< negative where a facet is thin: see thin_cell.h
  std::array<Row, kCorners<D>> areas, perimeters;
  // See CellTerms; `perimeter` is what of the facets is to be added to the length.
  Row singular, regular, singular_error, regular_error, perimeter;
};
struct FacetRows {
  Row area, perimeter;  // pi perimeters
};

[[gnu::always_inline]] inline void measure_lanes(const Batch<3, 4>& __restrict batch,
                                                 CellRows<3>& __restrict out) {
  alignas(64) std::array<Row, 6> lengths, cosines;
  for (std::size_t k = 0; k < kLanes; ++k) {
    const Vector a = vector(batch.x[0], k), b = vector(batch.x[1], k);
    const Vector c = vector(batch.x[2], k), d = vector(batch.x[3], k);
    const Vector ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b;
    const Vector n_d = cross(ab, ac), n_c = cross(ab, ad), n_b = cross(ac, ad), n_a = cross(bc, bd);
    out.volume[k] = std::abs(dot(ab, n_b));
    out.areas[0][k] = norm(n_a);
    out.areas[1][k] = norm(n_b);
    out.areas[2][k] = norm(n_c);
    out.areas[3][k] = norm(n_d);
    lengths[0][k] = norm(ab);
    lengths[1][k] = norm(ac);
    lengths[2][k] = norm(ad);
    lengths[3][k] = norm(bc);
    lengths[4][k] = norm(bd);
    lengths[5][k] = norm(d - c);
    // n_a and n_c point outward where n_b and n_d point inward, or the other way round.
    cosines[0][k] = -dot(n_c, n_d);
    cosines[1][k] = dot(n_b, n_d);
    cosines[2][k] = -dot(n_b, n_c);
    cosines[3][k] = -dot(n_a, n_d);
    cosines[4][k] = dot(n_a, n_c);
    cosines[5][k] = -dot(n_a, n_b);
  }
  // How far the facets are from thin: negative where one is.
  for (std::size_t k = 0; k < kLanes; ++k) {
    out.excess[k] = std::min(std::min(out.areas[0][k] - kThin * lengths[3][k] * lengths[4][k],
                                      out.areas[1][k] - kThin * lengths[1][k] * lengths[2][k]),
                             std::min(out.areas[2][k] - kThin * lengths[0][k] * lengths[2][k],
                                      out.areas[3][k] - kThin * lengths[0][k] * lengths[1][k]));
    out.perimeters[0][k] = lengths[3][k] + lengths[4][k] + lengths[5][k];
    out.perimeters[1][k] = lengths[1][k] + lengths[2][k] + lengths[5][k];
    out.perimeters[2][k] = lengths[0][k] + lengths[2][k] + lengths[4][k];
    out.perimeters[3][k] = lengths[0][k] + lengths[1][k] + lengths[3][k];
  }
  out.length.fill(0.0);
  for (std::size_t edge = 0; edge < 6; ++edge) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double sine = out.volume[k] * lengths[edge][k];
      out.length[k] += lengths[edge][k] * angle_from_x_axis(cosines[edge][k], sine);
    }
  }
}

[[gnu::always_inline]] inline void measure_lanes(const Batch<2, 3>& __restrict batch,
                                                 CellRows<2>& __restrict out) {
  const auto& [a, b, c] = batch.x;
  for (std::size_t k = 0; k < kLanes; ++k) {
    out.volume[k] = std::abs((b[0][k] - a[0][k]) * (c[1][k] - a[1][k]) -
                             (b[1][k] - a[1][k]) * (c[0][k] - a[0][k]));
    out.areas[0][k] = length(b, c, k);
    out.areas[1][k] = length(a, c, k);
    out.areas[2][k] = length(a, b, k);
  }
  out.length.fill(0.0);
  out.excess.fill(0.0);
}

[[gnu::always_inline]] inline void measure_lanes(const Batch<3, 3>& __restrict batch,
                                                 FacetRows& __restrict out) {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const Vector a = vector(batch.x[0], k), b = vector(batch.x[1], k), c = vector(batch.x[2], k);
    const Vector ab = b - a, ac = c - a;
    out.area[k] = norm(cross(ab, ac));
    out.perimeter[k] = times_pi(norm(ab) + norm(ac) + norm(c - b));
  }
}

[[gnu::always_inline]] inline void measure_lanes(const Batch<2, 2>& __restrict batch,
                                                 FacetRows& __restrict out) {
  for (std::size_t k = 0; k < kLanes; ++k) out.area[k] = length(batch.x[0], batch.x[1], k);
  out.perimeter.fill(0.0);
}

[[gnu::always_inline]] inline void measure_lanes(const Batch<3, 2>& __restrict batch,
                                                 Row& __restrict out) {
  for (std::size_t k = 0; k < kLanes; ++k) {
    out[k] = 2.0 * times_pi(norm(vector(batch.x[1], k) - vector(batch.x[0], k)));  // 2 pi lengths
  }
}

/// A double where all bits of `mask` are set, 0 where none is.
[[gnu::always_inline]] inline double masked(double value, std::uint64_t mask) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & mask);
}

/// The sums over the facets of each cell, from its roles: the last rows of `out`.
template <int D>
[[gnu::always_inline]] inline void sum_facets(const BitsRow& __restrict roles,
                                              CellRows<D>& __restrict out) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
  const auto all_if = [](std::uint64_t bit) __attribute__((always_inline)) {
    return std::uint64_t{0} - (bit & 1U);
  };
  for (std::size_t k = 0; k < kLanes; ++k) {
    double singular = 0.0, singular_error = 0.0, regular = 0.0, regular_error = 0.0, length = 0.0;
    for (std::size_t i = 0; i < kCorners<D>; ++i) {
      const std::uint64_t is_second = all_if(roles[k] >> i);
      const std::uint64_t enters_with = all_if(roles[k] >> (4 + i));
      const double area = out.areas[i][k];
      const double change =
          std::bit_cast<double>(std::bit_cast<std::uint64_t>(area) ^ (is_second & kSign));
      const Exactly of_regular = two_sum(regular, change);
      regular = of_regular.high;
      regular_error += of_regular.low;
      const Exactly of_singular = two_sum(singular, -masked(area, ~is_second & ~enters_with));
      singular = of_singular.high;
      singular_error += of_singular.low;
      if constexpr (D == 3) {
        length -= masked(out.perimeters[i][k], ~is_second & enters_with);
      }
    }
    out.regular[k] = regular;
    out.regular_error[k] = regular_error;
    out.singular[k] = singular;
    out.singular_error[k] = singular_error;
    out.perimeter[k] = D == 3 ? times_pi(length) : 0.0;
  }
}

[[gnu::always_inline]] inline void finish(const BitsRow*, FacetRows&) {}
[[gnu::always_inline]] inline void finish(const BitsRow*, Row&) {}
template <int D>
[[gnu::always_inline]] inline void finish(const BitsRow* roles, CellRows<D>& out) {
  sum_facets<D>(*roles, out);
}

/// Loads all lanes where `sites` is not null, measures them and, of cells, sums their facets.
template <int D, std::size_t N, class Rows>
[[gnu::always_inline]] inline void measure_inline(const Site<D>* sites,
                                                  const std::array<Vertices<N>, kLanes>& vertices,
                                                  const BitsRow* roles,
                                                  Batch<D, N>& __restrict batch,
                                                  Rows& __restrict out) {
  if (sites != nullptr) load_lanes<N>(sites, vertices, batch);
  measure_lanes(batch, out);
  finish(roles, out);
}

// The same bits with wider vectors, where the machine has them: no operation is fused with another.
template <int D, std::size_t N, class Rows>
ORTHOBALL_AVX2 void measure_wide(const Site<D>* sites,
                                 const std::array<Vertices<N>, kLanes>& vertices,
                                 const BitsRow* roles, Batch<D, N>& __restrict batch,
                                 Rows& __restrict out) {
  measure_inline(sites, vertices, roles, batch, out);
}

template <int D, std::size_t N, class Rows>
void measure(const Site<D>* sites, const std::array<Vertices<N>, kLanes>& vertices,
             const BitsRow* roles, Batch<D, N>& __restrict batch, Rows& __restrict out) {
  has_avx2() ? measure_wide(sites, vertices, roles, batch, out)
             : measure_inline(sites, vertices, roles, batch, out);
}

}  // namespace orthoball::measure_lanes_detail
