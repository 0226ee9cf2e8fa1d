// SPDX-License-Identifier: MIT
//
// A vector lane for each facet. The rows of the determinants (coordinates and lift, the query at
// the origin) and the minors of a facet's rows are worked out once for all neighbours; what a
// neighbour adds is its apex: the determinant is expanded by that row. The bound is that of the
// glance of power_side; docs/derivations/filters.md derives it.
#include "orthoball/exact/power_sides_across.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "orthoball/exact/processor.h"

namespace orthoball {

#ifdef ORTHOBALL_WIDE_CODE

namespace {

// Compiled for processors that have the vectors, whatever the rest is compiled for.
#define ORTHOBALL_FOUR_LANES __attribute__((target("avx2"), always_inline))

using Four = double __attribute__((vector_size(32)));
using FourBits = std::int64_t __attribute__((vector_size(32)));

// The coordinates and the weight.
ORTHOBALL_FOUR_LANES inline Four loaded(const Site<3>& site) {
  Four four;
  static_assert(sizeof four == sizeof site);
  std::memcpy(&four, &site, sizeof four);
  return four;
}
ORTHOBALL_FOUR_LANES inline Four all(double number) { return Four{number, number, number, number}; }
ORTHOBALL_FOUR_LANES inline Four absolute(Four a) {
  const FourBits bits = {INT64_MAX, INT64_MAX, INT64_MAX, INT64_MAX};
  return reinterpret_cast<Four>(reinterpret_cast<FourBits>(a) & bits);
}
ORTHOBALL_FOUR_LANES inline std::uint32_t signs(FourBits lanes) {
  return static_cast<std::uint32_t>(__builtin_ia32_movmskpd256(reinterpret_cast<Four>(lanes)));
}
// Lane i has what lane i + 1, i + 2, i + 3 had.
ORTHOBALL_FOUR_LANES inline Four next(Four a) { return __builtin_shufflevector(a, a, 1, 2, 3, 0); }
ORTHOBALL_FOUR_LANES inline Four second(Four a) {
  return __builtin_shufflevector(a, a, 2, 3, 0, 1);
}
ORTHOBALL_FOUR_LANES inline Four third(Four a) { return __builtin_shufflevector(a, a, 3, 0, 1, 2); }

// The rows of four corners, a column to a vector.
struct SpaceRows {
  Four x, y, z, lift;
  Four size;  // square sum and |weight|: at least |lift|
};

ORTHOBALL_FOUR_LANES inline SpaceRows rows(const Sites<3>& sites, const Corners<3>& corners,
                                           Four query) {
  const Four a = loaded(sites[corners[0]]) - query;
  const Four b = loaded(sites[corners[1]]) - query;
  const Four c = loaded(sites[corners[2]]) - query;
  const Four d = loaded(sites[corners[3]]) - query;
  const Four ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four ab_yw = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four cd_yw = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  SpaceRows rows;
  rows.x = __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5);
  rows.y = __builtin_shufflevector(ab_yw, cd_yw, 0, 1, 4, 5);
  rows.z = __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7);
  const Four weight = __builtin_shufflevector(ab_yw, cd_yw, 2, 3, 6, 7);
  const Four square = rows.x * rows.x + rows.y * rows.y + rows.z * rows.z;
  rows.lift = square - weight;
  rows.size = square + absolute(weight);
  return rows;
}

// The rows of three corners, the last one twice.
struct PlaneRows {
  Four x, y, lift, size;
};

ORTHOBALL_FOUR_LANES inline PlaneRows rows(const Sites<2>& sites, const Corners<2>& corners,
                                           const Site<2>& query) {
  const Site<2>& a = sites[corners[0]];
  const Site<2>& b = sites[corners[1]];
  const Site<2>& c = sites[corners[2]];
  PlaneRows rows;
  rows.x = Four{a.x[0], b.x[0], c.x[0], c.x[0]} - all(query.x[0]);
  rows.y = Four{a.x[1], b.x[1], c.x[1], c.x[1]} - all(query.x[1]);
  const Four weight = Four{a.weight, b.weight, c.weight, c.weight} - all(query.weight);
  const Four square = rows.x * rows.x + rows.y * rows.y;
  rows.lift = square - weight;
  rows.size = square + absolute(weight);
  return rows;
}

// Answers for the lanes of `facets`. What lies beyond the bound has the sign of the value; so has
// everything where the value is exact, which is asked only if something is left.
template <class IsExact>
ORTHOBALL_FOUR_LANES inline GlancedSides sides(std::uint32_t facets, Four value, FourBits beyond,
                                               const IsExact& is_exact) {
  const std::uint32_t positive = signs(value > all(0.0));
  const std::uint32_t known = signs(beyond) & facets;
  if (known == facets) return {positive & known, known & ~positive, 0};
  const std::uint32_t exact = signs(is_exact()) & facets;
  const std::uint32_t zero = exact & signs(value == all(0.0));
  return {positive & (known | exact), (known | exact) & ~(positive | zero), zero};
}

// The error of the weights counts as so much lift that its share of the bound is covered.
template <int D>
double lift_of_weight_error(const Sites<D>& sites) {
  return sites.weight_error() * 0x1p+52;
}

// Determinants whose products are at most this are exact; twice the room that filters.md asks for.
template <int D>
double exact_magnitude(const Sites<D>& sites) {
  return sites.is_integral() ? kExactIntegers / (2 * kPowerSideTerms<D>) : -1.0;
}

}  // namespace

bool can_glance_across() { return has_avx2(); }

ORTHOBALL_AVX2 GlancedSides glanced_power_sides_across(const Sites<3>& sites,
                                                       const Corners<3>& corners,
                                                       const Corners<3>& apexes,
                                                       std::uint32_t query) {
  const Four origin = loaded(sites[query]);
  const SpaceRows cell = rows(sites, corners, origin);
  const SpaceRows apex = rows(sites, apexes, origin);

  // The facet of lane i has the corners i + 1, i + 2, i + 3.
  const Four x1 = next(cell.x), x2 = second(cell.x), x3 = third(cell.x);
  const Four y1 = next(cell.y), y2 = second(cell.y), y3 = third(cell.y);
  const Four z1 = next(cell.z), z2 = second(cell.z), z3 = third(cell.z);
  const Four l1 = next(cell.lift), l2 = second(cell.lift), l3 = third(cell.lift);
  const Four xy12 = x1 * y2 - y1 * x2, xy23 = next(xy12), xy13 = x1 * y3 - y1 * x3;
  const Four zl12 = z1 * l2 - l1 * z2, zl23 = next(zl12), zl13 = z1 * l3 - l1 * z3;
  const Four xyz = z1 * xy23 - z2 * xy13 + z3 * xy12;
  const Four xyl = l1 * xy23 - l2 * xy13 + l3 * xy12;
  const Four xzl = x1 * zl23 - x2 * zl13 + x3 * zl12;
  const Four yzl = y1 * zl23 - y2 * zl13 + y3 * zl12;
  const Four value = (apex.lift * xyz - apex.z * xyl) + (apex.y * xzl - apex.x * yzl);

  const Four pairs = cell.size + second(cell.size);
  const Four size = pairs + next(pairs) + apex.size + all(lift_of_weight_error(sites));
  const Four magnitude = (size * size) * (size * size) * size;  // squared
  const Four bound = all(kPowerSideBound<3> * kPowerSideBound<3>) * magnitude;
  // A neighbour with the apex in the place of corner i is negatively oriented, and its rows come in
  // an odd order if i is odd.
  const Four turned = {-1.0, 1.0, -1.0, 1.0};
  return sides(0b1111U, value * turned, value * value > bound + all(kUnderflow * kUnderflow),
               [&]() ORTHOBALL_FOUR_LANES {
                 const double most = exact_magnitude<3>(sites);
                 return magnitude <= all(most * std::abs(most));
               });
}

ORTHOBALL_AVX2 GlancedSides glanced_power_sides_across(const Sites<2>& sites,
                                                       const Corners<2>& corners,
                                                       const Corners<2>& apexes,
                                                       std::uint32_t query) {
  const PlaneRows cell = rows(sites, corners, sites[query]);
  const PlaneRows apex = rows(sites, apexes, sites[query]);

  // The facet of lane i has the corners i + 1 and i + 2, of three.
  const auto first = [](Four a)
                         ORTHOBALL_FOUR_LANES { return __builtin_shufflevector(a, a, 1, 2, 0, 0); };
  const auto other = [](Four a)
                         ORTHOBALL_FOUR_LANES { return __builtin_shufflevector(a, a, 2, 0, 1, 1); };
  const Four x1 = first(cell.x), x2 = other(cell.x);
  const Four y1 = first(cell.y), y2 = other(cell.y);
  const Four l1 = first(cell.lift), l2 = other(cell.lift);
  const Four value = apex.lift * (x1 * y2 - y1 * x2) -
                     (apex.x * (l1 * y2 - y1 * l2) - apex.y * (l1 * x2 - x1 * l2));

  const Four size = cell.size + first(cell.size) + other(cell.size) + apex.size +
                    all(lift_of_weight_error(sites));
  const Four bound = all(kPowerSideBound<2>) * (size * size) + all(kUnderflow);
  return sides(0b111U, -value, absolute(value) > bound, [&]() ORTHOBALL_FOUR_LANES {
    return size * size <= all(exact_magnitude<2>(sites));
  });
}

#else

bool can_glance_across() { return false; }

GlancedSides glanced_power_sides_across(const Sites<3>&, const Corners<3>&, const Corners<3>&,
                                        std::uint32_t) {
  return {};
}
GlancedSides glanced_power_sides_across(const Sites<2>&, const Corners<2>&, const Corners<2>&,
                                        std::uint32_t) {
  return {};
}

#endif

}  // namespace orthoball
