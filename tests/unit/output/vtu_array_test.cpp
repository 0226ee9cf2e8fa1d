// SPDX-License-Identifier: MIT
#include "orthoball/output/vtu_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "unit/output/shapes.h"
#include "unit/output/written_bytes.h"

namespace orthoball {
namespace {

TEST(VtuArray, IsItsSizeThenItsBytesInBase64) {
  VtuArray array;
  for (const char c : {'M', 'a', 'n', '!'}) array.add(c);
  EXPECT_EQ(
      written([&](ByteSink& s) { array.write(s, "type=\"Int8\" Name=\"x\""); }),
      "<DataArray type=\"Int8\" Name=\"x\" format=\"binary\">BAAAAAAAAAA=TWFuIQ==</DataArray>\n");
}

TEST(VtuArray, HoldsAnyNumberOfNumbers) {
  for (const std::size_t count : {0U, 1U, 2U, 5000U}) {
    VtuArray array;
    std::vector<double> expected;
    for (std::size_t i = 0; i < count; ++i) {
      expected.push_back(1.0 / (static_cast<double>(i) + 1));
      array.add(expected.back());
    }
    const std::string text = written([&](ByteSink& s) { array.write(s, "Name=\"x\""); });
    EXPECT_EQ(numbers<double>(text, "x"), expected);
  }
}

TEST(VtuArray, IsPartOfAPiece) {
  EXPECT_EQ(written([](ByteSink& s) { write_vtu_piece(s, 12, 3); }),
            "<Piece NumberOfPoints=\"12\" NumberOfCells=\"3\">\n");
}

}  // namespace
}  // namespace orthoball
