// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

using Numbers = std::vector<double>;

Numbers numbers_of(const std::string& text, const ReadOptions& options = {}) {
  return coordinates_of(reading_of(read_geojson, text, options));
}

TEST(ReadGeojson, PointsStandAloneInFeaturesAndInCollections) {
  EXPECT_EQ(numbers_of(R"({"type": "Point", "coordinates": [8.5, -50]})"), (Numbers{8.5, -50}));
  EXPECT_EQ(numbers_of(R"({"type": "MultiPoint", "coordinates": [[1, 2], [3, 4]]})"),
            (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(numbers_of(R"({"type": "FeatureCollection", "features": [
                {"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 2]},
                 "properties": {"coordinates": "none", "geometry": {"type": "Polygon"}}},
                {"type": "Feature", "geometry": null, "properties": null},
                {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
                  {"type": "MultiPoint", "coordinates": []},
                  {"type": "Point", "coordinates": [3, 4]}]}}]})"),
            (Numbers{1, 2, 3, 4}));
}

TEST(ReadGeojson, TheTypeMayFollowTheCoordinates) {
  EXPECT_EQ(numbers_of(R"({"coordinates": [[1, 2], [3, 4]], "bbox": [0], "type": "MultiPoint"})"),
            (Numbers{1, 2, 3, 4}));
}

TEST(ReadGeojson, NumbersAreTheDecimalsOfTheText) {
  const Reading reading = reading_of(
      read_geojson, "{\"type\": \"MultiPoint\",\n\"coordinates\": [\n[0.1, -0.0],\n[1e-2, 5]\n]}");
  EXPECT_EQ(reading.points.decimals(), 2);
  EXPECT_EQ(reading.points.coordinates()[0], 10.0);
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{3, 4}));
}

TEST(ReadGeojson, PositionsMayHaveThreeNumbers) {
  const std::string text = R"({"type": "Point", "coordinates": [1, 2, 3]})";
  EXPECT_EQ(numbers_of(text), (Numbers{1, 2, 3}));
  EXPECT_EQ(numbers_of(text, {.dimension = 2}), (Numbers{1, 2}));
  EXPECT_EQ(reading_of(read_geojson, text, {.radius_column = "3"}).points.weight(0), 9.0);
}

TEST(ReadGeojson, OtherGeometriesAreRefusedByName) {
  EXPECT_EQ(error_of(read_geojson,
                     "{\"type\": \"Polygon\",\n \"coordinates\": [[[0,0],[1,0],[0,1],[0,0]]]}"),
            "f:2: a geometry of type \"Polygon\"; only Point and MultiPoint are read");
  EXPECT_NE(error_of(read_geojson, R"({"type": "Topology", "objects": {}})").find("Topology"),
            std::string::npos);
}

TEST(ReadGeojson, RefusesCoordinatesThatAreNone) {
  for (const char* coordinates :
       {"[]", "[1]", "[[1, 2]]", "1", "null", "[1, null]", "[\"1\", 2]", "[1, [2]]", "{}",
        "[{}, 1]", "[1, true]", "[1, 1e400]", "[1, 2", "[1, 2]]"}) {
    EXPECT_NE(error_of(read_geojson,
                       std::string(R"({"type": "Point", "coordinates": )") + coordinates + "}"),
              "")
        << coordinates;
  }
  for (const char* coordinates : {"[1, 2]", "[[1, 2], 3]", "[[[1, 2]]]", "[[1, 2], [1, 2, 3]]",
                                  "[[1, 2], []]", "[[1, 2], [[3, 4]]]"}) {
    EXPECT_NE(error_of(read_geojson, std::string(R"({"type": "MultiPoint", "coordinates": )") +
                                         coordinates + "}"),
              "")
        << coordinates;
  }
}

TEST(ReadGeojson, RefusesWhatIsNoGeojsonWithTheLine) {
  EXPECT_EQ(error_of(read_geojson, "{\"type\":\n \"Point\",\n ]").substr(0, 4), "f:3:");
  EXPECT_NE(error_of(read_geojson, ""), "");
  EXPECT_NE(error_of(read_geojson, "[1, 2]"), "");
  EXPECT_NE(error_of(read_geojson, "{}"), "");
  EXPECT_NE(error_of(read_geojson, R"({"type": "Point"})"), "");
  EXPECT_NE(error_of(read_geojson, std::string(100000, '[')), "");
}

}  // namespace
}  // namespace orthoball
