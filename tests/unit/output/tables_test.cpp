// SPDX-License-Identifier: MIT
#include "orthoball/output/tables.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

Shapes<2> right_triangle() { return Shapes<2>({0, 0, 4, 0, 0, 3}); }

TEST(FilterTable, CsvHasOneRowASimplexInFilterOrder) {
  const auto shapes = right_triangle();
  const std::string csv =
      written([&](ByteSink& s) { write_filter_csv(s, Filter<2>(shapes.filtration), 7); });
  EXPECT_EQ(csv,
            "position,dimension,vertices,alpha2,enters,regular,interior\n"
            "1,0,0,0,1,2,\n"
            "2,0,1,0,1,3,\n"
            "3,0,2,0,1,2,\n"
            "4,1,0 2,2.25,2,4,\n"
            "5,1,0 1,4,3,4,\n"
            "6,1,1 2,6.25,4,4,\n"
            "7,2,0 1 2,6.25,4,4,4\n");
}

TEST(FilterTable, JsonLinesSayTheSameWithNullForNever) {
  const auto shapes = right_triangle();
  const std::string text =
      written([&](ByteSink& s) { write_filter_json_lines(s, Filter<2>(shapes.filtration), 7); });
  std::istringstream lines(text);
  std::string line;
  int count = 0;
  while (std::getline(lines, line)) {
    const auto json = nlohmann::json::parse(line);
    EXPECT_EQ(json["position"], ++count);
    EXPECT_EQ(json["interior"].is_null(), count < 7);
  }
  EXPECT_EQ(count, 7);
  EXPECT_NE(text.find("\"vertices\":[0,1,2],\"alpha2\":6.25,\"enters\":4,\"regular\":4"),
            std::string::npos);
}

TEST(FilterTable, HoldsThePrefixThatIsAskedFor) {
  const auto shapes = right_triangle();
  const Filter<2> filter(shapes.filtration);
  const std::string csv =
      written([&](ByteSink& s) { write_filter_csv(s, filter, filter.complex_size(2)); });
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
}

TEST(FilterTable, NpzNamesItsArrays) {
  const auto shapes = right_triangle();
  const std::string npz =
      written([&](ByteSink& s) { write_filter_npz(s, Filter<2>(shapes.filtration), 7); });
  for (const char* const name :
       {"dimension.npy", "vertices.npy", "alpha2.npy", "enters.npy", "spectrum.npy"}) {
    EXPECT_NE(npz.find(name), std::string::npos);
  }
  EXPECT_NE(npz.find("'shape': (7,3,)"), std::string::npos);
}

template <int D>
SignatureRow<D> row() {
  SignatureRow<D> row;
  row.signature.index = 3;
  row.signature.alpha2 = 0.25;
  row.signature.betti[0] = 2;
  row.signature.euler = -1;
  row.signature.volume = 1.5;
  row.signature.length = 9.0;
  row.alpha = 0.5;
  return row;
}

TEST(SignatureTable, CsvHeadAndRowsHaveTheSameColumns) {
  const std::string space = written([](ByteSink& s) {
    write_signature_head_csv<3>(s);
    write_signature_csv(s, row<3>());
  });
  EXPECT_EQ(space,
            "index,alpha2,alpha,betti_0,betti_1,betti_2,euler,exterior_0,exterior_1,exterior_2,"
            "exterior_3,singular_0,singular_1,singular_2,singular_3,regular_0,regular_1,regular_2,"
            "regular_3,interior_0,interior_1,interior_2,interior_3,volume,area_singular,"
            "area_regular,area,length\n"
            "3,0.25,0.5,2,0,0,-1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1.5,0,0,0,9\n");
  const std::string plane = written([](ByteSink& s) {
    write_signature_head_csv<2>(s);
    write_signature_csv(s, row<2>());
  });
  EXPECT_EQ(std::count(plane.begin(), plane.end(), ','), 2 * 22);
  EXPECT_EQ(plane.substr(plane.size() - 3), "0,\n");
}

TEST(SignatureTable, JsonHasArraysByDimensionAndNoLengthInThePlane) {
  const auto space =
      nlohmann::json::parse(written([](ByteSink& s) { write_signature_json(s, row<3>()); }));
  EXPECT_EQ(space["betti"], nlohmann::json({2, 0, 0}));
  EXPECT_EQ(space["singular"].size(), 4U);
  EXPECT_EQ(space["length"], 9);
  const auto plane =
      nlohmann::json::parse(written([](ByteSink& s) { write_signature_json(s, row<2>()); }));
  EXPECT_TRUE(plane["length"].is_null());
  EXPECT_EQ(plane["exterior"].size(), 3U);
}

TEST(SignatureTable, NumbersBeyondTheDoubleRangeAreNull) {
  auto large = row<3>();
  large.signature.volume = std::numeric_limits<double>::infinity();
  const auto json =
      nlohmann::json::parse(written([&](ByteSink& s) { write_signature_json(s, large); }));
  EXPECT_TRUE(json["volume"].is_null());
}

}  // namespace
}  // namespace orthoball
