// SPDX-License-Identifier: MIT
#include "orthoball/exact/local_frame.h"

#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <vector>

#include "generators/random.h"
#include "oracles/exact_predicates.h"
#include "tuples.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;
using oracles::Integer;
using oracles::Rational;

constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr double kMost = std::numeric_limits<double>::max();

template <int N>
Integer integer(const WideInteger<N>& number) {
  Integer sum = 0;
  for (std::size_t i = std::size_t{N}; i-- > 0;) sum = (sum << 64) + number.limbs()[i];
  return number.sign() == Sign::negative ? Integer(sum - (Integer(1) << (64 * N))) : sum;
}

template <int D>
Rational weight_of(const ExactSite<D>& site) {
  return (Rational(site.weight_high) + Rational(site.weight_low)) *
         oracles::power_of_two(site.weight_exponent);
}

// What LocalFrame promises, and that integer_site keeps it. Returns the frame.
template <int D>
LocalFrame check_frame(const std::vector<ExactSite<D>>& sites) {
  const LocalFrame frame = local_frame<D>(sites);
  const Rational unit = oracles::power_of_two(frame.unit);
  const Rational bound = oracles::power_of_two(frame.bits);
  EXPECT_GE(frame.bits, 1);
  for (const ExactSite<D>& a : sites) {
    for (const ExactSite<D>& b : sites) {
      for (std::size_t axis = 0; axis < D; ++axis) {
        EXPECT_LT(abs(Rational(a.x[axis]) - Rational(b.x[axis])) / unit, bound);
      }
      EXPECT_LT(abs(weight_of<D>(a) - weight_of<D>(b)) / unit / unit, bound * bound);
    }
    EXPECT_LT(abs(weight_of<D>(a)) / unit / unit, bound * bound);
    const auto check = [&]<int N>() {
      const auto relative = integer_site<WideInteger<2 * N>, D>(a, sites[0], frame);
      for (std::size_t axis = 0; axis < D; ++axis) {
        EXPECT_EQ(Rational(integer(relative.x[axis])) * unit,
                  Rational(a.x[axis]) - Rational(sites[0].x[axis]));
      }
      EXPECT_EQ(Rational(integer(relative.weight)) * unit * unit, weight_of<D>(a));
    };
    with_limbs(frame.bits, check);
  }
  return frame;
}

template <int D>
void check_family(PointFamily family, std::uint64_t seed) {
  const Sites<D> sites = tuples::sites_of<D>(points_of(family, D, 30, seed));
  Random random(seed);
  for (int i = 0; i < 20; ++i) {
    std::vector<ExactSite<D>> chosen;
    for (const std::uint32_t row : tuples::any_rows<D + 2>(random, sites.size())) {
      chosen.push_back(sites.exact(row));
    }
    check_frame<D>(chosen);
  }
}

TEST(LocalFrame, BoundsDifferencesAndWeightsOfEveryFamily) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      check_family<2>(family, seed);
      check_family<3>(family, seed);
    }
  }
}

TEST(LocalFrame, BoundsTheLeastAndTheMostNumbers) {
  const std::vector<double> extremes{0,          kLeast,      -kLeast, 2 * kLeast, 3 * kLeast,
                                     5 * kLeast, -7 * kLeast, kMost,   -kMost,     1};
  for (const double a : extremes) {
    for (const double b : extremes) {
      for (const double c : extremes) {
        check_frame<2>({{{a, 0}, 0, 0, 0}, {{b, 0}, 0, 0, 0}, {{c, 1}, 0, 0, 0}});
        check_frame<2>({{{a, 0}, 0, 0, 0}, {{b, 0}, 0, 0, 0}, {{c, 0}, 0, 0, 0}});
        check_frame<2>({{{a, 0}, b, 0, 0}, {{0, b}, c, 0, 0}});
        check_frame<2>({{{a, 0}, 0.75, 0x1p-60, 2046}, {{0, b}, 0.5, 0, -2040}});
      }
    }
  }
}

TEST(LocalFrame, CountsBitsOfTheDifferencesAtHand) {
  const double far = 0x1p+40;
  const LocalFrame frame = check_frame<2>({{{far, 0}, 0, 0, 0}, {{far + 3, 1}, 0, 0, 0}});
  EXPECT_EQ(frame.unit, 0);
  EXPECT_LE(frame.bits, 4);
  const LocalFrame coarse = check_frame<2>({{{far, 0}, 0, 0, 0}, {{-far, far}, 0, 0, 0}});
  EXPECT_EQ(coarse.unit, 40);
  EXPECT_LE(coarse.bits, 4);
}

TEST(LocalFrame, CountsBitsOfWeightsOfRadii) {
  // A square of 53 bits of radius: two doubles.
  const double radius = 0x1.FFFFFFFFFFFFFp+0;
  const Sites<2> sites =
      tuples::sites_of<2>({2, {0, 0, 1, 1}, WeightKind::radius, {radius, -radius}});
  const LocalFrame frame = check_frame<2>({sites.exact(0), sites.exact(1)});
  EXPECT_EQ(frame.unit, -52);
  EXPECT_LE(frame.bits, 56);
}

TEST(LocalFrame, OfOneCentreHasOneBit) {
  EXPECT_EQ(check_frame<2>({{{3, 5}, 0, 0, 0}, {{3, 5}, 0, 0, 0}}).bits, 1);
  EXPECT_EQ(check_frame<2>({{{0, 0}, 0, 0, 0}}).bits, 1);
}

TEST(WithLimbs, OffersTwoBitsToSpareUpToTheDifferencesOfAnyDoubles) {
  const auto limbs = [](int bits) { return with_limbs(bits, []<int N>() { return N; }); };
  for (int bits = 1; bits <= 2301; ++bits) EXPECT_GE(64 * limbs(bits) - 3, bits);
  EXPECT_EQ(limbs(61), 1);
  EXPECT_EQ(limbs(62), 2);
  EXPECT_EQ(limbs(253), 4);
  EXPECT_EQ(limbs(510), 36);
}

TEST(WithWidth, OffersMoreThanTheBitsAsked) {
  const auto width = [](int bits) {
    return with_width(bits, []<class Int>() { return Int::kBits; });
  };
  for (const int bits : {1, 126, 127, 254, 255, 511, 1023, 4094, 4095, 40000}) {
    EXPECT_GT(width(bits), bits + 1);
  }
}

}  // namespace
}  // namespace orthoball
