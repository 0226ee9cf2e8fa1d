// SPDX-License-Identifier: MIT
#include "orthoball/output/region_files.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "orthoball/output/region_mesh.h"
#include "unit/output/shapes.h"

namespace orthoball {
namespace {

// The corners of two cubes that are next to each other, whose voids are open at `kAlpha2`.
constexpr double kAlpha2 = 0.6;

Shapes<3> cubes() {
  std::vector<double> coordinates;
  for (const double x : {0.0, 1.0, 2.0}) {
    for (const auto& [y, z] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
      coordinates.insert(coordinates.end(), {x, double(y), double(z)});
    }
  }
  return Shapes<3>(std::move(coordinates));
}

struct Found {
  Found()
      : shapes(cubes()),
        index(shapes.filtration.index(kAlpha2)),
        all(voids<3>(shapes.filtration, index, kAlpha2, VoidsOf::balls)) {
    regions = {"void", "balls", "two\ncubes.xyz", 0.0, index, kAlpha2, {}};
    regions.all = shown_regions<3>(all);
  }

  Shapes<3> shapes;
  std::uint32_t index;
  std::vector<Void<3>> all;
  ShownRegions regions;
};

TEST(RegionFiles, VoidsAreShownWithTheirLargestBalls) {
  const Found found;
  ASSERT_EQ(found.regions.all.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const ShownRegion& shown = found.regions.all[i];
    EXPECT_EQ(shown.kind, "void");
    EXPECT_EQ(shown.volume, found.all[i].volume);
    EXPECT_EQ(shown.area, found.all[i].area);
    EXPECT_EQ(shown.cells.data(), found.all[i].cells.data());
    EXPECT_EQ(shown.lining.size(), 8U);
    ASSERT_TRUE(shown.largest);
    EXPECT_EQ(shown.largest->radius, found.all[i].largest_ball_radius);
  }
}

TEST(RegionFiles, PocketsAreShownByTheirKind) {
  const Found found;
  const auto pockets = orthoball::pockets<3>(found.shapes.filtration, found.index, kAlpha2);
  const auto shown = shown_regions(std::span(pockets));
  ASSERT_EQ(shown.size(), pockets.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i].kind, "void");
    EXPECT_EQ(shown[i].volume, pockets[i].volume);
    EXPECT_FALSE(shown[i].largest);
  }
}

TEST(RegionFiles, TheMeshIsThatOfTheCellsUnderATitleOfOneLine) {
  const Found found;
  const std::string ply = written([&](ByteSink& sink) {
    write_regions_mesh<3>(sink, found.shapes.filtration, found.shapes.points, found.regions);
  });
  std::vector<std::span<const SimplexId>> cells;
  for (const Void<3>& hole : found.all) cells.push_back(hole.cells);
  const auto mesh =
      region_mesh<3>(found.shapes.filtration, found.shapes.points, found.index, cells);
  const std::string title =
      "voids of the balls of two cubes.xyz at alpha2 0.6, index " + std::to_string(found.index);
  EXPECT_EQ(ply, written([&](ByteSink& sink) {
              write_region_ply<3>(sink, mesh, {title, "void", false});
            }));
}

TEST(RegionFiles, TheScriptNamesEveryRegionAndTheProbe) {
  Found found;
  found.regions.probe = 1.4;
  found.regions.name = "pocket";
  const std::string script = written([&](ByteSink& sink) {
    write_regions_script(sink, Viewer::pymol, found.shapes.filtration, found.regions,
                         "data/cubes.xyz", {});
  });
  for (const char* text : {"data/cubes.xyz", "with a probe of 1.4 at alpha2 0.6", "pocket_1",
                           "pocket_2", "pocket 2: void, volume "}) {
    EXPECT_NE(script.find(text), std::string::npos) << text << "\n" << script;
  }
}

}  // namespace
}  // namespace orthoball
