// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/territory_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "generators/point_families.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::points_of;

template <int D>
Sites<D> sites_of(const WeightedPoints& points) {
  std::vector<SiteId> rows;
  for (std::uint32_t row = 0; row < points.size(); ++row) rows.push_back(SiteId(row));
  return Sites<D>(points, rows);
}

template <int D>
std::vector<std::size_t> sites_in(const std::vector<Box<D>>& boxes, const Sites<D>& sites) {
  std::vector<std::size_t> counts(boxes.size(), 0);
  for (std::size_t site = 0; site < sites.size(); ++site) {
    std::size_t having = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!boxes[i].has(sites[site])) continue;
      ++having;
      ++counts[i];
    }
    EXPECT_EQ(having, 1U) << "site " << site;
  }
  return counts;
}

template <int D>
void check_shares(std::size_t count) {
  const Sites<D> sites = sites_of<D>(points_of(PointFamily::uniform, D, 20000, 1));
  std::vector<std::uint32_t> all(sites.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto counts = sites_in<D>(territory_boxes<D>(sites, all, count), sites);
  EXPECT_EQ(counts.size(), count);
  const std::size_t fair = sites.size() / count;
  EXPECT_LT(*std::max_element(counts.begin(), counts.end()), 3 * fair);
  EXPECT_GT(*std::min_element(counts.begin(), counts.end()), fair / 3);
}

TEST(TerritoryBoxes, ShareAllSites) {
  for (const std::size_t count : {1U, 2U, 3U, 7U, 16U}) {
    check_shares<2>(count);
    check_shares<3>(count);
  }
}

TEST(TerritoryBoxes, AreCutWhereSitesAreSparse) {
  // Two layers across x, wide apart.
  std::vector<double> x;
  for (int i = 0; i < 4000; ++i) {
    x.insert(x.end(), {i < 2000 ? 0.25 : 0.75, i * 0.61803 - static_cast<int>(i * 0.61803),
                       i * 0.41421 - static_cast<int>(i * 0.41421)});
  }
  const Sites<3> sites = sites_of<3>(WeightedPoints(3, x, WeightKind::none, {}));
  std::vector<std::uint32_t> all(sites.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto boxes = territory_boxes<3>(sites, all, 2);
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_GT(boxes[0].high[0], sites[0].x[0]);
  EXPECT_LT(boxes[0].high[0], sites[3999].x[0]);
  EXPECT_EQ(sites_in<3>(boxes, sites), (std::vector<std::size_t>{2000, 2000}));
}

TEST(TerritoryBoxes, OfSitesInOnePlaceAreOne) {
  const Sites<2> sites =
      sites_of<2>(WeightedPoints(2, std::vector<double>(4000, 3.0), WeightKind::none, {}));
  std::vector<std::uint32_t> all(sites.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto counts = sites_in<2>(territory_boxes<2>(sites, all, 8), sites);
  EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 2000U);
}

}  // namespace
}  // namespace orthoball
