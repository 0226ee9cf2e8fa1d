// SPDX-License-Identifier: MIT
// Our pairs beside those of GUDHI's persistent cohomology, of the same simplices with our indices
// as values: multisets of births and deaths off the diagonal.
#include <gtest/gtest.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <tuple>

#include "generators/cases.h"
#include "matchers/reference_inputs.h"
#include "orthoball/topology/persistence.h"
#include "orthoball/triangulation/build.h"
#include "peers/peer_sites.h"

namespace orthoball::peers {
namespace {

// Dimension, birth, death (0 for never), ascending.
using Lives = std::vector<std::tuple<int, std::uint32_t, std::uint32_t>>;

template <int D>
Lives lives_by_gudhi(const Filtration<D>& filtration) {
  Gudhi::Simplex_tree<> tree;
  for (std::uint32_t i = 0; i < filtration.size(); ++i) {
    std::vector<int> vertices;
    for (const VertexId vertex : filtration.vertices(SimplexId(i))) {
      vertices.push_back(static_cast<int>(vertex.row()));
    }
    tree.insert_simplex(vertices, filtration.enters(SimplexId(i)));
  }
  Gudhi::persistent_cohomology::Persistent_cohomology<Gudhi::Simplex_tree<>,
                                                      Gudhi::persistent_cohomology::Field_Zp>
      cohomology(tree, /*persistence_dim_max=*/true);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(/*min_interval_length=*/0);
  Lives lives;
  for (int k = 0; k < D; ++k) {
    for (const auto& [birth, death] : cohomology.intervals_in_dimension(k)) {
      lives.emplace_back(k, static_cast<std::uint32_t>(birth),
                         std::isinf(death) ? 0U : static_cast<std::uint32_t>(death));
    }
  }
  std::sort(lives.begin(), lives.end());
  return lives;
}

template <int D>
void expect_same_lives(const Filtration<D>& filtration) {
  Lives lives;
  const PersistencePairs<D> pairs = persistence_pairs(filtration);
  for (int k = 0; k < D; ++k) {
    for (const PersistencePair& pair : pairs[static_cast<std::size_t>(k)]) {
      lives.emplace_back(k, filtration.enters(pair.birth),
                         pair.death.exists() ? filtration.enters(pair.death) : 0U);
    }
  }
  std::sort(lives.begin(), lives.end());
  EXPECT_EQ(lives, lives_by_gudhi(filtration));
}

template <int D>
void expect_same_lives_of_families(std::size_t count) {
  for_each_family(D, count, /*seeds=*/2, [](const WeightedPoints& points) {
    expect_same_lives(Filtration<D>(regular_triangulation<D>(points)));
  });
}

TEST(GudhiPersistence, PairsTheSameInThePlane) { expect_same_lives_of_families<2>(2000); }

TEST(GudhiPersistence, PairsTheSameInSpace) { expect_same_lives_of_families<3>(600); }

class ReferenceInput : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(ReferenceInput, PairsTheSame) {
  if (GetParam().empty()) GTEST_SKIP() << "no ../shared/reference beside the project";
  const WeightedPoints points = matchers::reference_points(matchers::reference_results(GetParam()));
  constexpr std::size_t kFew = 1500;
  if (points.size() > kFew && !generators::is_long_run()) {
    GTEST_SKIP() << points.size() << " points: in the long form";
  }
  if (points.dimension() == 2) {
    expect_same_lives(Filtration<2>(regular_triangulation<2>(points)));
  } else {
    expect_same_lives(Filtration<3>(regular_triangulation<3>(points)));
  }
}

INSTANTIATE_TEST_SUITE_P(Files, ReferenceInput, testing::ValuesIn(matchers::reference_files()),
                         [](const auto& info) { return matchers::reference_name(info.param); });

}  // namespace
}  // namespace orthoball::peers
