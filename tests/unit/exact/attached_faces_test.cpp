// SPDX-License-Identifier: MIT
#include "orthoball/exact/attached_faces.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <string>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::points_of;

// What the corners beside the face of one simplex less attach, by integers alone.
template <int D, std::size_t Corners>
unsigned exactly_attached(const Sites<D>& sites, const CornerSites<4>& cell, unsigned simplex) {
  CornerSites<Corners> corners{};
  std::array<unsigned, Corners> places{};
  std::size_t size = 0;
  for (unsigned corner = 0; corner < 4; ++corner) {
    if ((simplex >> corner & 1U) == 0) continue;
    places[size] = corner;
    corners[size++] = cell[corner];
  }
  const unsigned facets = orthoradius_stages::exact_attached_facets<D, Corners>(sites, corners);
  unsigned faces = 0;
  for (std::size_t i = 0; i < Corners; ++i) {
    if ((facets >> i & 1U) != 0) faces |= 1U << (simplex & ~(1U << places[i]));
  }
  return faces;
}

template <int D>
void expect_exact_faces(const WeightedPoints& points, const std::string& what) {
  const auto triangulation = regular_triangulation<D>(points);
  const Sites<D>& sites = triangulation.sites();
  std::vector<CornerSites<std::size_t{D} + 1>> cells;
  for (const auto& record : triangulation.template cells<D>()) cells.push_back(record.corners);
  std::vector<std::uint16_t> faces(cells.size());
  attached_faces<D, std::size_t{D} + 1>(sites, cells, faces);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    CornerSites<4> corners{};
    std::copy(cells[cell].begin(), cells[cell].end(), corners.begin());
    unsigned expected = 0;
    for (unsigned simplex = 1; simplex < 2U << D; ++simplex) {
      const int size = std::popcount(simplex);
      if (size == 2) expected |= exactly_attached<D, 2>(sites, corners, simplex);
      if (size == 3) expected |= exactly_attached<D, 3>(sites, corners, simplex);
      if constexpr (D == 3) {
        if (size == 4) expected |= exactly_attached<D, 4>(sites, corners, simplex);
      }
    }
    ASSERT_EQ(faces[cell], expected) << what << ", cell " << cell;
  }
}

TEST(AttachedFaces, AreThoseOfEveryFaceByItself) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const std::string what = std::string(name(family)) + " " + std::to_string(seed);
      expect_exact_faces<2>(points_of(family, 2, 60, seed), what);
      expect_exact_faces<3>(points_of(family, 3, 60, seed), what);
    }
  }
}

}  // namespace
}  // namespace orthoball
