// SPDX-License-Identifier: MIT
#include "orthoball/queries/representatives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "generators/cases.h"
#include "orthoball/error.h"
#include "orthoball/queries/regions.h"
#include "orthoball/queries/voids.h"
#include "orthoball/triangulation/build.h"
#include "unit/output/shapes.h"

namespace orthoball {
namespace {

using Chain = std::set<SimplexId>;  // over Z/2

void add(Chain& chain, const Chain& other) {
  for (const SimplexId simplex : other) {
    if (!chain.insert(simplex).second) chain.erase(simplex);
  }
}

template <int D>
Chain boundary(const Filtration<D>& filtration, SimplexId simplex) {
  const auto facets = filtration.facets(simplex);
  return {facets.begin(), facets.end()};
}

// Whether a chain is a sum of others, by elimination.
class Span {
 public:
  bool add_to_basis(Chain chain) {
    reduce(chain);
    if (chain.empty()) return false;
    const SimplexId last = *chain.rbegin();
    basis_.emplace(last, std::move(chain));
    return true;
  }
  [[nodiscard]] bool contains(Chain chain) const {
    reduce(chain);
    return chain.empty();
  }

 private:
  void reduce(Chain& chain) const {
    Chain rest;
    while (!chain.empty()) {
      const auto found = basis_.find(*chain.rbegin());
      if (found != basis_.end()) {
        add(chain, found->second);
      } else {
        rest.insert(*chain.rbegin());
        chain.erase(std::prev(chain.end()));
      }
    }
    chain = rest;
  }
  std::map<SimplexId, Chain> basis_;  // by their last simplices
};

// The boundaries of the (k + 1)-simplices of a complex, without the simplices of an earlier one.
template <int D>
Span boundaries(const Filtration<D>& filtration, int k, std::uint32_t index,
                std::uint32_t without = 0) {
  Span span;
  const std::uint32_t first = filtration.table().first(k + 1);
  for (std::uint32_t i = 0; i < filtration.count(k + 1); ++i) {
    if (filtration.enters(SimplexId(first + i)) > index) continue;
    Chain chain = boundary(filtration, SimplexId(first + i));
    std::erase_if(chain, [&](SimplexId s) { return filtration.enters(s) <= without; });
    span.add_to_basis(chain);
  }
  return span;
}

template <int D>
void check_cycle(const Filtration<D>& filtration, const Representative& one) {
  const Chain cycle(one.cycle.begin(), one.cycle.end());
  ASSERT_FALSE(cycle.empty());
  Chain of_cycle;
  for (const SimplexId simplex : cycle) {
    EXPECT_EQ(filtration.dimension(simplex), one.dimension);
    EXPECT_LE(filtration.enters(simplex), one.index);
    add(of_cycle, boundary(filtration, simplex));
  }
  EXPECT_TRUE(of_cycle.empty());

  const std::uint32_t birth = filtration.enters(one.pair.birth);
  const std::uint32_t death = filtration.enters(one.pair.death);
  EXPECT_FALSE(boundaries(filtration, one.dimension, death - 1).contains(cycle));
  EXPECT_TRUE(boundaries(filtration, one.dimension, death).contains(cycle));
  // A tunnel's is homologous to a cycle that was there at its birth; a void may have been divided.
  // None is homologous to a cycle that was there before.
  Chain later = cycle;
  std::erase_if(later, [&](SimplexId s) { return filtration.enters(s) <= birth; });
  if (one.cells.empty()) {
    EXPECT_TRUE(boundaries(filtration, one.dimension, one.index, birth).contains(later));
  }
  if (one.index != birth) return;
  Chain fresh = cycle;
  std::erase_if(fresh, [&](SimplexId s) { return filtration.enters(s) < birth; });
  EXPECT_FALSE(boundaries(filtration, one.dimension, birth, birth - 1).contains(fresh));
}

void check_rings(const Representative& one) {
  std::size_t edges = 0;
  for (const auto& ring : one.rings) {
    edges += ring.size();
    EXPECT_GE(ring.size(), 3U);
    EXPECT_EQ(std::set<SiteId>(ring.begin(), ring.end()).size(), ring.size());
  }
  EXPECT_EQ(edges, one.cycle.size());
}

template <class Check>
void for_each_class(std::size_t largest, const Check& check) {
  const auto visit = [&]<int D>(const generators::Case& one) {
    SCOPED_TRACE(::testing::Message() << one);
    const Filtration<D> filtration(regular_triangulation<D>(one.points()));
    const auto all = persistence_pairs(filtration, WantedPairs::all);
    Representatives<D> representatives(filtration, all);
    const auto lasting = persistence_pairs(filtration);
    for (int k = 0; k < D; ++k) {
      for (const PersistencePair& pair : lasting[static_cast<std::size_t>(k)]) {
        check(filtration, representatives, k, pair);
      }
    }
  };
  for (const generators::Case& one : generators::cases(2, 1, largest)) {
    if (generators::is_extreme(one.family)) continue;
    if (one.dimension == 2) visit.template operator()<2>(one);
    if (one.dimension == 3) visit.template operator()<3>(one);
    if (::testing::Test::HasFailure()) return;  // one case tells enough
  }
}

TEST(Representatives, AreCyclesThatBoundNothingFromBirthToDeath) {
  std::array<std::size_t, 3> count{};
  for_each_class(30, [&]<int D>(const Filtration<D>& filtration, Representatives<D>& of, int k,
                                const PersistencePair& pair) {
    if (k == 0) return;
    ++count[static_cast<std::size_t>(k)];
    const std::uint32_t birth = filtration.enters(pair.birth);
    const std::uint32_t last = filtration.enters(pair.death) - 1;
    for (const std::uint32_t index : {birth, birth + (last - birth) / 2, last}) {
      const Representative one = of.at(k, pair, index);
      check_cycle(filtration, one);
      if (k == 1) check_rings(one);
      EXPECT_GT(one.size, 0.0);
    }
  });
  EXPECT_GT(count[1], 100U);
  EXPECT_GT(count[2], 50U);
}

TEST(Representatives, OfComponentsAreThoseThatTheEdgesJoin) {
  for_each_class(20, [&]<int D>(const Filtration<D>& filtration, Representatives<D>& of, int k,
                                const PersistencePair& pair) {
    if (k > 0) return;
    const std::uint32_t index = of.usual_index(k, pair);
    const Representative one = of.at(k, pair, index);
    const SiteId began = filtration.triangulation().sites().row(pair.birth.row());
    const auto parts = regions(AlphaComplex<D>(filtration, index), JoinedBy::vertices);
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Region& region) {
      return std::binary_search(region.rows.begin(), region.rows.end(), began);
    });
    ASSERT_NE(found, parts.end());
    EXPECT_EQ(one.rows, found->rows);
  });
}

TEST(Representatives, OfVoidsAreTheCellsOfTheComplement) {
  for_each_class(30, [&]<int D>(const Filtration<D>& filtration, Representatives<D>& of, int k,
                                const PersistencePair& pair) {
    if (k < D - 1 || filtration.triangulation().affine_dimension() < D) return;
    const std::uint32_t birth = filtration.enters(pair.birth);
    const Representative one = of.at(k, pair, birth);
    for (const Void<D>& hole : voids(filtration, birth, filtration.alpha2(birth), VoidsOf::shape)) {
      if (std::count(hole.cells.begin(), hole.cells.end(), pair.death) == 0) continue;
      EXPECT_EQ(one.cells, hole.cells);
      EXPECT_NEAR(one.volume, hole.volume, 1e-12 * hole.volume);
    }
  });
}

TEST(Representatives, OfARingIsItsShortestWayAround) {
  // Two squares, one above the other, a long way around a hole through which nothing goes.
  Shapes<3> shapes({1,  0, 0,   0, 1,  0,   -1, 0, 0,   0,  -1, 0,   3,  0,  0.1, 0, 3,  0.1,
                    -3, 0, 0.1, 0, -3, 0.1, 2,  2, 0.2, -2, 2,  0.2, -2, -2, 0.2, 2, -2, 0.2});
  const auto all = persistence_pairs(shapes.filtration, WantedPairs::all);
  Representatives<3> of(shapes.filtration, all);
  const auto lasting = persistence_pairs(shapes.filtration);
  PersistencePair longest = lasting[1].at(0);
  const auto life = [&](const PersistencePair& pair) {
    return shapes.filtration.alpha2(shapes.filtration.enters(pair.death)) -
           shapes.filtration.alpha2(shapes.filtration.enters(pair.birth));
  };
  for (const PersistencePair& pair : lasting[1]) {
    if (life(pair) > life(longest)) longest = pair;
  }
  const Representative one = of.at(1, longest, of.usual_index(1, longest));
  ASSERT_EQ(one.rings.size(), 1U);
  EXPECT_EQ(one.rows, (std::vector<SiteId>{SiteId(0), SiteId(1), SiteId(2), SiteId(3)}));
  EXPECT_DOUBLE_EQ(one.size, 4 * std::sqrt(2.0));
}

// What was found for one question serves others.
TEST(Representatives, DoNotDependOnTheOrderOfQuestions) {
  for (const generators::Case& one : generators::cases(2, 1, 40)) {
    if (one.dimension != 3 || generators::is_extreme(one.family)) continue;
    SCOPED_TRACE(::testing::Message() << one);
    const Filtration<3> filtration(regular_triangulation<3>(one.points()));
    const auto all = persistence_pairs(filtration, WantedPairs::all);
    const auto tunnels = persistence_pairs(filtration)[1];
    using Question = std::pair<PersistencePair, std::uint32_t>;
    std::vector<Question> questions;
    for (const PersistencePair& pair : tunnels) {
      const std::uint32_t birth = filtration.enters(pair.birth);
      const std::uint32_t last = filtration.enters(pair.death) - 1;
      for (const std::uint32_t index : {birth, birth + (last - birth) / 2, last}) {
        questions.emplace_back(pair, index);
      }
    }
    const auto answer = [](Representatives<3>& of, const Question& question) {
      return of.at(1, question.first, question.second).cycle;
    };
    Representatives<3> ascending(filtration, all), shuffled(filtration, all);
    std::map<std::size_t, std::vector<SimplexId>> known;
    const auto order = generators::random_permutation(questions.size(), one.seed);
    for (const std::uint32_t i : order) known[i] = answer(shuffled, questions[i]);
    std::vector<std::size_t> by_index(order.begin(), order.end());
    std::sort(by_index.begin(), by_index.end(), [&](std::size_t a, std::size_t b) {
      return questions[a].second < questions[b].second;
    });
    for (const std::size_t i : by_index) EXPECT_EQ(answer(ascending, questions[i]), known[i]);
    if (::testing::Test::HasFailure()) return;  // one case tells enough
  }
}

TEST(Representatives, DoNotDependOnTheOrderOfRows) {
  for (const generators::Case& one : generators::cases(1, 5, 200)) {
    if (one.dimension != 3 || generators::is_extreme(one.family)) continue;
    SCOPED_TRACE(::testing::Message() << one);
    const WeightedPoints points = one.points();
    const auto rows = generators::random_permutation(one.count, one.seed);
    const Filtration<3> one_way(regular_triangulation<3>(points));
    const Filtration<3> other_way(regular_triangulation<3>(generators::with_rows(points, rows)));
    const auto all = persistence_pairs(one_way, WantedPairs::all);
    Representatives<3> of_one(one_way, all), of_other(other_way, all);
    const auto lasting = persistence_pairs(one_way);
    for (const PersistencePair& pair : lasting[1]) {
      const std::uint32_t index = of_one.usual_index(1, pair);
      EXPECT_EQ(of_one.at(1, pair, index).cycle, of_other.at(1, pair, index).cycle);
    }
  }
}

TEST(Representatives, AreRefusedBeforeBirthAndAfterDeath) {
  const Shapes<2> shapes({0, 0, 1, 0, 1, 1, 0, 1});
  const auto pairs = persistence_pairs(shapes.filtration, WantedPairs::all);
  Representatives<2> of(shapes.filtration, pairs);
  const auto hole = persistence_pairs(shapes.filtration)[1].at(0);
  EXPECT_EQ(of.at(1, hole, 2).rows.size(), 4U);
  EXPECT_EQ(of.at(1, hole, 2).volume, 1.0);
  EXPECT_THROW((void)of.at(1, hole, 1), InputError);
  EXPECT_THROW((void)of.at(1, hole, 3), InputError);
}

}  // namespace
}  // namespace orthoball
