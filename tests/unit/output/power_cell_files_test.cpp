// SPDX-License-Identifier: MIT
#include "orthoball/output/power_cell_files.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "unit/output/shapes.h"
#include "unit/output/written_bytes.h"

namespace orthoball {
namespace {

// Rows 1 and 2 of three: a square and a cell without a surface.
std::vector<PowerCell<2>> planar_cells() {
  PowerCell<2> square{SiteId(1), 1.0, 4.0, 3.0, 1, true, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}, {}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    square.facets.push_back({i == 1 ? SiteId(2) : SiteId(), 0, 2 * i, 2 * i + 2});
    square.loops.insert(square.loops.end(), {i, (i + 1) % 4});
  }
  PowerCell<2> bare;
  bare.row = SiteId(2);
  bare.volume = std::numeric_limits<double>::infinity();
  bare.facet_count = 1;
  return {square, bare};
}

// Halves of a box.
std::vector<PowerCell<3>> halves() {
  const Shapes<3> shapes({0, 0, 0, 0, 0, 2});
  return power_cells(shapes.filtration, {{-1, -1, -1}, {1, 1, 3}}, {.threads = Threads(1)});
}

TEST(PowerCellTable, HasALineForEveryRow) {
  SiteLabels labels;
  labels.element = {"C", "N", "O"};
  const auto cells = planar_cells();
  EXPECT_EQ(
      written([&](ByteSink& s) { write_power_cells<2>(s, TableFormat::csv, cells, 4, labels); }),
      "row,chain,residue,atom,element,volume,area,exposed_area,facets,is_clipped\n"
      "0,,,,C,0,0,0,0,0\n"
      "1,,,,N,1,4,3,1,1\n"
      "2,,,,O,null,0,0,1,0\n"
      "3,,,,,0,0,0,0,0\n");
}

TEST(PowerCellObj, HasAnObjectForEverySurface) {
  const auto cells = planar_cells();
  EXPECT_EQ(written([&](ByteSink& s) { write_power_cells_obj<2>(s, cells, "cells"); }),
            "# cells\no row_1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const auto in_space = halves();
  const std::string obj =
      written([&](ByteSink& s) { write_power_cells_obj<3>(s, in_space, "cells"); });
  std::size_t faces = 0, corners = 0;
  std::uint32_t largest = 0;
  std::istringstream lines(obj);
  for (std::string word; lines >> word;) {
    if (word == "v") ++corners;
    if (word != "f") continue;
    ++faces;
    for (int i = 0; i < 4; ++i) {
      std::uint32_t corner = 0;
      lines >> corner;
      EXPECT_GT(corner, faces <= 6 ? 0U : 8U);
      largest = std::max(largest, corner);
    }
  }
  EXPECT_EQ(faces, 12U);
  EXPECT_EQ(corners, 16U);
  EXPECT_EQ(largest, 16U);
  EXPECT_NE(obj.find("o row_0\n"), std::string::npos);
  EXPECT_NE(obj.find("o row_1\n"), std::string::npos);
}

TEST(PowerCellVtu, HoldsPolyhedraWithTheirNumbers) {
  const auto cells = halves();
  const std::string vtu = written([&](ByteSink& s) { write_power_cells_vtu<3>(s, cells); });
  EXPECT_NE(vtu.find("NumberOfPoints=\"16\" NumberOfCells=\"2\""), std::string::npos);
  EXPECT_EQ(data_array(vtu, "types"), std::string(2, 42));
  EXPECT_EQ(numbers<std::int64_t>(vtu, "offsets"), (std::vector<std::int64_t>{8, 16}));
  EXPECT_EQ(numbers<std::uint32_t>(vtu, "row"), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(numbers<double>(vtu, "volume"), (std::vector<double>{8, 8}));
  EXPECT_EQ(numbers<double>(vtu, "area"), (std::vector<double>{24, 24}));
  EXPECT_EQ(numbers<double>(vtu, "exposed_area"), (std::vector<double>{20, 20}));
  EXPECT_EQ(numbers<std::uint32_t>(vtu, "facets"), (std::vector<std::uint32_t>{1, 1}));
  EXPECT_EQ(data_array(vtu, "is_clipped"), std::string(2, 1));
  // Each cell: the number of its faces, and of every face the number of its corners and these.
  const auto faces = numbers<std::int64_t>(vtu, "faces");
  const auto face_offsets = numbers<std::int64_t>(vtu, "faceoffsets");
  const auto points = numbers<double>(vtu, "points");
  ASSERT_EQ(face_offsets, (std::vector<std::int64_t>{31, 62}));
  ASSERT_EQ(faces.size(), 62U);
  for (std::size_t cell = 0; cell < 2; ++cell) {
    EXPECT_EQ(faces[31 * cell], 6);
    for (std::size_t face = 0; face < 6; ++face) {
      const std::size_t at = 31 * cell + 1 + 5 * face;
      EXPECT_EQ(faces[at], 4);
      for (std::size_t i = 1; i <= 4; ++i) {
        const auto corner = static_cast<std::size_t>(faces[at + i]);
        EXPECT_EQ(corner / 8, cell);
        const double z = points[3 * corner + 2];
        EXPECT_TRUE(cell == 0 ? z <= 1 : z >= 1);
      }
    }
  }
}

TEST(PowerCellVtu, HoldsPolygonsOfThePlane) {
  const auto cells = planar_cells();
  const std::string vtu = written([&](ByteSink& s) { write_power_cells_vtu<2>(s, cells); });
  EXPECT_EQ(data_array(vtu, "types"), std::string(1, 7));
  EXPECT_EQ(numbers<std::int64_t>(vtu, "connectivity"), (std::vector<std::int64_t>{0, 1, 2, 3}));
  EXPECT_EQ(numbers<double>(vtu, "points"),
            (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(vtu.find("faceoffsets"), std::string::npos);
}

}  // namespace
}  // namespace orthoball
