// SPDX-License-Identifier: MIT
#include "orthoball/queries/alpha_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "generators/cases.h"
#include "orthoball/queries/manifold_solid.h"
#include "orthoball/triangulation/build.h"
#include "unit/output/shapes.h"

namespace orthoball {
namespace {

template <int D>
AlphaCandidate<D> candidate(const Filtration<D>& filtration, const std::string& name,
                            WeightMeaning weights = WeightMeaning::none) {
  for (const auto& one : alpha_candidates(filtration, weights)) {
    if (one.alpha.name == name) return one;
  }
  return {};
}

// 16 integer points of one circle of radius 25, evenly enough.
Shapes<2> ring() {
  return Shapes<2>({25,  0, 24,  7,  15,  20,  7,  24,  0, 25,  -7, 24,  -15, 20,  -24, 7,
                    -25, 0, -24, -7, -15, -20, -7, -24, 0, -25, 7,  -24, 15,  -20, 24,  -7});
}

TEST(AlphaCandidates, BeginWithTheTopologyThatLastsLongest) {
  const Shapes<2> shapes = ring();
  const auto all = alpha_candidates(shapes.filtration, WeightMeaning::none);
  EXPECT_EQ(all[0].alpha.name, "signature");
  EXPECT_EQ(all[0].at.betti, (BettiNumbers<2>{1, 1}));
  EXPECT_EQ(all[0].stable_to, shapes.filtration.index(625.0));
  EXPECT_EQ(shapes.filtration.alpha2(all[0].stable_from), 250.0 / 4);  // the longest edge
  EXPECT_DOUBLE_EQ(all[0].stability, 25 / std::sqrt(62.5));
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_LE(all[i].alpha.index.has_value(), all[i - 1].alpha.index.has_value());
    EXPECT_TRUE(!all[i].alpha.index || all[i].stability <= all[i - 1].stability);
  }
}

TEST(AlphaCandidates, HaveTheFirstClosedManifoldWithAllVertices) {
  const auto check = [&]<int D>(const Filtration<D>& filtration) {
    const auto notables = notable_alphas(filtration);
    std::optional<std::uint32_t> first;
    for (std::uint32_t i = notables[1].index.value_or(filtration.never());
         i < filtration.never() && !first; ++i) {
      bool is_smooth = true;
      for (std::uint32_t s = 0; s < filtration.size() && is_smooth; ++s) {
        is_smooth = filtration.role(SimplexId(s), i) != Role::singular;
      }
      if (is_smooth && manifold_solid(AlphaComplex(filtration, i)).offending.empty()) first = i;
    }
    EXPECT_EQ(candidate(filtration, "manifold").alpha.index, first);
  };
  for (const generators::Case& one : generators::cases(2, 1, 25)) {
    SCOPED_TRACE(::testing::Message() << one);
    if (generators::is_extreme(one.family)) continue;
    if (one.dimension == 2) check(Filtration<2>(regular_triangulation<2>(one.points())));
    if (one.dimension == 3) check(Filtration<3>(regular_triangulation<3>(one.points())));
  }
}

TEST(AlphaCandidates, HaveThePlateauOfADenseSquareAmongFewPoints) {
  std::vector<double> coordinates{30, 0, 0, 30, 30, 30};
  for (int x = 0; x <= 4; ++x) {
    for (int y = 0; y <= 4; ++y) coordinates.insert(coordinates.end(), {double(x), double(y)});
  }
  const Shapes<2> shapes(coordinates);
  const auto plateau = candidate(shapes.filtration, "plateau_1");
  ASSERT_TRUE(plateau.alpha.index);
  EXPECT_EQ(plateau.at.volume, 16.0);
  EXPECT_EQ(plateau.alpha.alpha2, 0.5);  // nothing enters until far later
  EXPECT_EQ(candidate(shapes.filtration, "spectrum_gap").at.volume, 16.0);
}

TEST(AlphaCandidates, OfMoleculesAreTheMoleculeAndAProbe) {
  const Shapes<3> shapes = mixed_shapes();
  EXPECT_EQ(candidate(shapes.filtration, "dual_complex").alpha.name, "");
  const auto radii = WeightMeaning::molecule_radii;
  EXPECT_EQ(candidate(shapes.filtration, "dual_complex", radii).alpha.alpha2, 0.0);
  EXPECT_DOUBLE_EQ(candidate(shapes.filtration, "probe", radii).alpha.alpha2, 1.96);
}

TEST(AlphaCandidates, OfNoSitesHaveNoIndex) {
  const Filtration<3> none(regular_triangulation<3>(WeightedPoints(3)));
  for (const auto& one : alpha_candidates(none, WeightMeaning::molecule_radii)) {
    EXPECT_FALSE(one.alpha.index);
  }
}

TEST(AlphaCandidates, HaveNamesThatCanBeAskedFor) {
  const Shapes<3> shapes = mixed_shapes();
  const auto names = candidate_names(3);
  for (const auto& one : alpha_candidates(shapes.filtration, WeightMeaning::molecule_radii)) {
    EXPECT_EQ(std::count(names.begin(), names.end(), one.alpha.name), 1) << one.alpha.name;
  }
}

TEST(AlphaSpreads, AreNoneWhereEveryPartIsTheWhole) {
  const Shapes<2> shapes = ring();
  const auto candidates = alpha_candidates(shapes.filtration, WeightMeaning::none);
  const auto spreads = alpha_spreads<2>(shapes.points, candidates, WeightMeaning::none,
                                        {.count = 3, .share = 1.0, .seed = 1});
  ASSERT_EQ(spreads.size(), candidates.size());
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    EXPECT_EQ(spreads[i].found, candidates[i].alpha.index ? 3U : 0U);
    EXPECT_EQ(spreads[i].same_betti, spreads[i].found);
    EXPECT_EQ(spreads[i].low, spreads[i].found > 0 ? candidates[i].alpha.alpha : 0.0);
    EXPECT_EQ(spreads[i].high, spreads[i].low);
  }
}

TEST(AlphaSpreads, CountWhatIsFoundAgainInParts) {
  const auto points = generators::points_of(generators::PointFamily::uniform, 3, 200, 5);
  const Filtration<3> filtration(regular_triangulation<3>(points));
  const auto candidates = alpha_candidates(filtration, WeightMeaning::none);
  const ResampleOptions options{.count = 8, .share = 0.8, .seed = 3};
  const auto spreads = alpha_spreads<3>(points, candidates, WeightMeaning::none, options);
  const auto shuffled =
      generators::with_rows(points, generators::random_permutation(points.size(), 9));
  const auto again = alpha_spreads<3>(shuffled, candidates, WeightMeaning::none, options);
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    EXPECT_LE(spreads[i].low, spreads[i].median);
    EXPECT_LE(spreads[i].median, spreads[i].high);
    EXPECT_EQ(spreads[i].median, again[i].median);
    if (candidates[i].alpha.name != "connected") continue;
    EXPECT_EQ(spreads[i].found, 8U);
    EXPECT_LT(spreads[i].low, spreads[i].high);
    EXPECT_NEAR(spreads[i].median, candidates[i].alpha.alpha, 0.1);
  }
}

}  // namespace
}  // namespace orthoball
