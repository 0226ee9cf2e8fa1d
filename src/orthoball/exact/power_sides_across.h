// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "orthoball/exact/four_lanes.h"
#include "orthoball/exact/orient.h"

namespace orthoball {

/// Power sides of one query to several simplices, as far as a glance tells: a bit for each simplex,
/// in exactly one of the masks.
struct GlancedSides {
  std::uint32_t positive = 0;
  std::uint32_t negative = 0;
  std::uint32_t zero = 0;  ///< a tie: told where numbers are small integers
  std::uint32_t open = 0;  ///< not known
};

#ifdef ORTHOBALL_WIDE_CODE

/// A query that looks at many simplices, one after the other, each with all its neighbours.
///
/// A vector lane for each facet. The rows of the determinants (coordinates and lift, the query at
/// the origin) and the minors of a facet's rows are worked out once for all neighbours; what a
/// neighbour adds is its apex: the determinant is expanded by that row. In space the facet of lane
/// i has the corners i ^ 1, i ^ 2 and i ^ 3: an even permutation for every i. The bound is that of
/// the glance of power_side; docs/derivations/filters.md derives it.
///
/// Only for processors with vectors of four doubles.
template <int D>
class PowerSidesAcross;

template <>
class PowerSidesAcross<3> {
 public:
  /// Keeps a reference.
  ORTHOBALL_AVX2 PowerSidesAcross(const Sites<3>& sites, std::uint32_t query)
      : sites_(sites), query_(four_lanes::loaded(sites[query])) {}

  /// The power sides of the query to all neighbours of a positively oriented simplex: bit i is for
  /// the neighbour across the facet opposite corner i, whose own corner off that facet is
  /// apexes[i]. What is told is exact; little is left open on sites in general position. Costs less
  /// than two calls of power_side.
  [[nodiscard]] ORTHOBALL_AVX2 GlancedSides operator()(const Corners<3>& corners,
                                                       const Corners<3>& apexes) const {
    using namespace four_lanes;
    const Rows cell = rows(corners), apex = rows(apexes);
    const Four x1 = turned1(cell.x), x2 = turned2(cell.x), x3 = turned1(x2);
    const Four y1 = turned1(cell.y), y2 = turned2(cell.y), y3 = turned1(y2);
    const Four z1 = turned1(cell.z), z2 = turned2(cell.z), z3 = turned1(z2);
    const Four l1 = turned1(cell.lift), l2 = turned2(cell.lift), l3 = turned1(l2);
    const Four xy12 = x1 * y2 - y1 * x2, xy13 = x1 * y3 - y1 * x3, xy23 = x2 * y3 - y2 * x3;
    const Four zl12 = z1 * l2 - l1 * z2, zl13 = z1 * l3 - l1 * z3, zl23 = z2 * l3 - l2 * z3;
    const Four xyz = z1 * xy23 - z2 * xy13 + z3 * xy12;
    const Four xyl = l1 * xy23 - l2 * xy13 + l3 * xy12;
    const Four xzl = x1 * zl23 - x2 * zl13 + x3 * zl12;
    const Four yzl = y1 * zl23 - y2 * zl13 + y3 * zl12;
    const Four value = (apex.lift * xyz - apex.z * xyl) + (apex.y * xzl - apex.x * yzl);

    const Four pairs = cell.size + turned1(cell.size);
    const Four size = pairs + turned2(pairs) + apex.size;
    const Four magnitude = (size * size) * (size * size) * size;  // squared
    const Four bound =
        all(kPowerSideBound<3> * kPowerSideBound<3>) * magnitude + all(kUnderflow * kUnderflow);
    // With the apex in the place of a corner the simplex is negatively oriented.
    const std::uint32_t positive = signs(reinterpret_cast<FourBits>(value));
    const std::uint32_t known = signs(value * value > bound);
    if (known == 0b1111U) [[likely]] {
      return {positive, known & ~positive, 0, 0};
    }
    return with_integers(positive, known, value, magnitude);
  }

 private:
  using Four = four_lanes::Four;
  // A column to a vector.
  struct Rows {
    Four x, y, z, lift;
    Four size;  // square sum and |weight|: at least |lift|
  };

  [[nodiscard, gnu::always_inline]] ORTHOBALL_AVX2 Rows rows(const Corners<3>& corners) const {
    const auto [x, y, z, weight] = four_lanes::columns(sites_, corners, query_);
    const Four square = x * x + y * y + z * z;
    return {x, y, z, square - weight, square + (four_lanes::absolute(weight) + weight_lift_)};
  }

  // What is known where determinants of integers have no error at all.
  [[nodiscard, gnu::noinline]] ORTHOBALL_AVX2 GlancedSides with_integers(std::uint32_t positive,
                                                                         std::uint32_t known,
                                                                         Four value,
                                                                         Four magnitude) const {
    using namespace four_lanes;
    const double most = kExactIntegers / (2 * kPowerSideTerms<3>);
    const std::uint32_t exact =
        sites_.is_integral() ? signs(magnitude <= all(most * most)) & ~known : 0;
    const std::uint32_t zero = exact & signs(value == all(0.0));
    const std::uint32_t told = known | (exact & ~zero);
    return {positive & told, told & ~positive, zero, 0b1111U & ~(known | exact)};
  }

  const Sites<3>& sites_;
  Four query_;
  // The error of the weights counts as so much lift that its share of the bound is covered.
  Four weight_lift_ = four_lanes::all(sites_.weight_error() * 0x1p+50);
};

template <>
class PowerSidesAcross<2> {
 public:
  /// Keeps a reference.
  PowerSidesAcross(const Sites<2>& sites, std::uint32_t query)
      : sites_(sites), query_(sites[query]) {}

  /// The same in the plane: three bits.
  [[nodiscard]] ORTHOBALL_AVX2 GlancedSides operator()(const Corners<2>& corners,
                                                       const Corners<2>& apexes) const {
    using namespace four_lanes;
    const Rows cell = rows(corners), apex = rows(apexes);
    const Four x1 = after(cell.x), x2 = before(cell.x);
    const Four y1 = after(cell.y), y2 = before(cell.y);
    const Four l1 = after(cell.lift), l2 = before(cell.lift);
    const Four value = apex.lift * (x1 * y2 - y1 * x2) -
                       (apex.x * (l1 * y2 - y1 * l2) - apex.y * (l1 * x2 - x1 * l2));

    const Four size = cell.size + after(cell.size) + before(cell.size) + apex.size;
    const Four magnitude = size * size;
    const Four bound = all(kPowerSideBound<2>) * magnitude + all(kUnderflow);
    const std::uint32_t positive = signs(reinterpret_cast<FourBits>(value)) & 0b111U;
    const std::uint32_t known = signs(absolute(value) > bound) & 0b111U;
    if (known == 0b111U) [[likely]] {
      return {positive, known & ~positive, 0, 0};
    }
    return with_integers(positive, known, value, magnitude);
  }

 private:
  using Four = four_lanes::Four;
  struct Rows {  // of three corners, the last one twice
    Four x, y, lift, size;
  };

  // The facet of lane i has the corners i + 1 and i + 2, of three.
  [[gnu::always_inline]] ORTHOBALL_AVX2 static Four after(Four a) {
    return __builtin_shufflevector(a, a, 1, 2, 0, 0);
  }
  [[gnu::always_inline]] ORTHOBALL_AVX2 static Four before(Four a) {
    return __builtin_shufflevector(a, a, 2, 0, 1, 1);
  }

  [[nodiscard, gnu::always_inline]] ORTHOBALL_AVX2 Rows rows(const Corners<2>& corners) const {
    using namespace four_lanes;
    const Site<2>& a = sites_[corners[0]];
    const Site<2>& b = sites_[corners[1]];
    const Site<2>& c = sites_[corners[2]];
    const Four x = Four{a.x[0], b.x[0], c.x[0], c.x[0]} - all(query_.x[0]);
    const Four y = Four{a.x[1], b.x[1], c.x[1], c.x[1]} - all(query_.x[1]);
    const Four weight = Four{a.weight, b.weight, c.weight, c.weight} - all(query_.weight);
    const Four square = x * x + y * y;
    return {x, y, square - weight, square + absolute(weight) + all(weight_lift_)};
  }

  [[nodiscard, gnu::noinline]] ORTHOBALL_AVX2 GlancedSides with_integers(std::uint32_t positive,
                                                                         std::uint32_t known,
                                                                         Four value,
                                                                         Four magnitude) const {
    using namespace four_lanes;
    const double most = kExactIntegers / (2 * kPowerSideTerms<2>);
    const std::uint32_t exact =
        sites_.is_integral() ? signs(magnitude <= all(most)) & 0b111U & ~known : 0;
    const std::uint32_t zero = exact & signs(value == all(0.0));
    const std::uint32_t told = known | (exact & ~zero);
    return {positive & told, told & ~positive, zero, 0b111U & ~(known | exact)};
  }

  const Sites<2>& sites_;
  Site<2> query_;
  double weight_lift_ = sites_.weight_error() * 0x1p+51;
};

#endif

}  // namespace orthoball
