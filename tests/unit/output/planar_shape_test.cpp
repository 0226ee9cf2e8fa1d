// SPDX-License-Identifier: MIT
#include "orthoball/output/planar_shape.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

// A square with its middle, an edge, and a point.
Shapes<2> three_things() { return Shapes<2>({0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5, 9, 0, 9, 1, 5, 9}); }

nlohmann::json geojson(const Shapes<2>& shapes, double alpha2, bool is_regularized = false) {
  const AlphaComplex<2> complex(shapes.filtration, shapes.filtration.index(alpha2));
  return nlohmann::json::parse(written([&](ByteSink& s) {
    write_geojson(s, is_regularized ? regularized(complex) : complex, shapes.points, {alpha2});
  }));
}

TEST(GeoJson, HoldsTheInteriorSingularEdgesAndSingularVertices) {
  const auto json = geojson(three_things(), 0.25);
  EXPECT_EQ(json["type"], "FeatureCollection");
  ASSERT_EQ(json["features"].size(), 3U);
  const auto& area = json["features"][0];
  EXPECT_EQ(area["geometry"]["type"], "MultiPolygon");
  EXPECT_EQ(area["properties"]["role"], "regular");
  EXPECT_EQ(area["properties"]["alpha2"], 0.25);
  const auto& ring = area["geometry"]["coordinates"][0][0];
  ASSERT_EQ(ring.size(), 5U);
  EXPECT_EQ(ring[0], ring[4]);
  EXPECT_EQ(area["properties"]["rows"][0][0].size(), 4U);
  EXPECT_EQ(json["features"][1]["geometry"]["type"], "LineString");
  EXPECT_EQ(json["features"][1]["properties"]["role"], "singular");
  EXPECT_EQ(json["features"][2]["geometry"]["coordinates"], nlohmann::json({5, 9}));
  EXPECT_EQ(json["features"][2]["properties"]["row"], 7);
}

TEST(GeoJson, RegularizedHoldsTheInteriorOnly) {
  EXPECT_EQ(geojson(three_things(), 0.25, true)["features"].size(), 1U);
}

TEST(GeoJson, AnEmptyShapeIsACollectionWithoutFeatures) {
  EXPECT_TRUE(geojson(three_things(), -1.0)["features"].empty());
  EXPECT_TRUE(geojson(Shapes<2>({}), 0.0)["features"].empty());
}

TEST(ShapeSvg, DrawsYUpwards) {
  const auto shapes = three_things();
  const std::string svg = written([&](ByteSink& s) {
    const AlphaComplex complex(shapes.filtration, shapes.filtration.index(0.25));
    write_shape_svg(s, complex, shapes.points, {0.25, true});
  });
  EXPECT_NE(svg.find("d=\"M464.44 20h0\""), std::string::npos) << svg;  // (5, 9) is at the top
  EXPECT_NE(svg.find("class=\"regular\""), std::string::npos);
}

TEST(ShapeSvg, APictureOfNothingOrOnePointHasASize) {
  for (const auto& coordinates : {std::vector<double>{}, std::vector<double>{3, 4}}) {
    const Shapes<2> shapes(coordinates);
    const std::string svg = written([&](ByteSink& s) {
      write_shape_svg(s, AlphaComplex(shapes.filtration, 0), shapes.points, {});
    });
    EXPECT_NE(svg.find("width=\"40\" height=\"40\""), std::string::npos) << svg;
  }
}

}  // namespace
}  // namespace orthoball
