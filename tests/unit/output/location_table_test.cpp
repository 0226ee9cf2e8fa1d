// SPDX-License-Identifier: MIT
#include "orthoball/output/location_table.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

std::string table(TableFormat format, std::uint32_t index) {
  const Shapes<2> shapes({0, 0, 4, 0, 0, 4});
  const WeightedPoints points(2, {1, 0.5, 1, -3}, WeightKind::none, {});
  const auto locations = locate(AlphaComplex<2>(shapes.filtration, index), points);
  return written([&](ByteSink& s) { write_locations<2>(s, format, shapes.filtration, locations); });
}

TEST(LocationTable, HasALineForEveryPoint) {
  EXPECT_EQ(table(TableFormat::csv, 3),
            "row,inside,region,distance,x,y,nearest,simplex\n"
            "0,1,1,0.5,1,0,0 1,0 1 2\n"
            "1,0,,3,1,0,0 1,\n");
  EXPECT_EQ(
      table(TableFormat::json, 3),
      "[\n"
      "{\"row\":0,\"inside\":1,\"region\":1,\"distance\":0.5,\"x\":1,\"y\":0,\"nearest\":[0,1],"
      "\"simplex\":[0,1,2]},\n"
      "{\"row\":1,\"inside\":0,\"region\":null,\"distance\":3,\"x\":1,\"y\":0,\"nearest\":[0,1],"
      "\"simplex\":null}\n]\n");
}

TEST(LocationTable, WithoutBoundaryHasNoDistance) {
  EXPECT_EQ(table(TableFormat::json, 0).find("distance\":null") == std::string::npos, false);
  EXPECT_NE(table(TableFormat::json, 0).find("\"nearest\":null,\"simplex\":[0,1,2]"),
            std::string::npos);
}

}  // namespace
}  // namespace orthoball
