// SPDX-License-Identifier: MIT
#include "orthoball/output/points_table.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace orthoball {
namespace {

std::string table(const WeightedPoints& points) {
  std::ostringstream text;
  ByteSink sink(text);
  write_points_csv(sink, points);
  return text.str();
}

TEST(PointsTable, WritesDecimalsDigitByDigit) {
  EXPECT_EQ(table(WeightedPoints::fixed_point(2, 3, {1, -12000, 45, 1230}, WeightKind::weight,
                                              {0x1p+60, -250000}, {1, 0})),
            "x,y,weight\n0.001,-12,1152921504606.846977\n0.045,1.23,-0.25\n");
  EXPECT_EQ(table(WeightedPoints::fixed_point(3, 1, {1, 0, -5}, WeightKind::radius, {-15})),
            "x,y,z,radius\n0.1,0,-0.5,-1.5\n");
  EXPECT_EQ(table(WeightedPoints::fixed_point(2, 0, {1, 100}, WeightKind::none, {})),
            "x,y\n1,100\n");
}

TEST(PointsTable, WritesDoublesAsTheShortestTextThatReadsBack) {
  EXPECT_EQ(table(WeightedPoints(2, {0.1 + 0.2, -0.0}, WeightKind::radius, {1e300})),
            "x,y,radius\n0.30000000000000004,0,1e+300\n");
}

}  // namespace
}  // namespace orthoball
