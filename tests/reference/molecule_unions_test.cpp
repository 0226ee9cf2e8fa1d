// SPDX-License-Identifier: MIT
// Unions of atoms of the shared data, where that folder lies beside the project, against numbers
// that AlphaMol gives.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "orthoball/input/read.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

const std::filesystem::path kData =
    std::filesystem::path(ORTHOBALL_SOURCE_DIR) / ".." / "shared" / "data";

// The atoms that have something in their names, or all, their radii larger by a probe's; all radii
// alike where `radius` is not 0.
UnionOfBalls union_of(const std::string& file, const ReadOptions& options, const std::string& atom,
                      double radius, double probe, std::size_t atoms) {
  const Reading reading = read((kData / file).string(), options);
  const WeightedPoints& points = reading.points;
  std::vector<double> coordinates, radii;
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (!atom.empty() && reading.labels.atom[row].find(atom) == std::string::npos) continue;
    for (int axis = 0; axis < 3; ++axis) coordinates.push_back(points.coordinate(row, axis));
    const double unit = std::pow(10.0, points.decimals().value_or(0));
    radii.push_back((radius > 0.0 ? radius : points.weights()[row] / unit) + probe);
  }
  EXPECT_EQ(radii.size(), atoms);
  const Filtration<3> filtration(
      regular_triangulation<3>(WeightedPoints(3, coordinates, WeightKind::radius, radii)));
  return union_of_balls(filtration, filtration.index(0.0), 0.0, {});
}

TEST(MoleculeUnions, AgreeWithAlphaMol) {
  if (!std::filesystem::exists(kData / "mol")) GTEST_SKIP() << "no data in ../shared/data";
  const UnionOfBalls fragment =
      union_of("points/Vol100.txt", {.dimension = 3, .radius_column = "4"}, "", 0.0, 0.0, 100);
  EXPECT_NEAR(fragment.area, 1392.59221801, 1e-7);
  EXPECT_NEAR(fragment.volume, 1289.07156684, 1e-7);
  EXPECT_EQ(fragment.euler, -14);
  EXPECT_NEAR(fragment.mean_curvature, 327.45, 0.05);  // sampled

  const UnionOfBalls trace = union_of("mol/1tim.pdb", {}, "CA", 1.9, 1.4, 494);
  EXPECT_NEAR(trace.area, 27430.23156951, 1e-6);
  EXPECT_NEAR(trace.volume, 52712.29004304, 1e-6);
  EXPECT_EQ(trace.euler, -98);
  EXPECT_NEAR(trace.mean_curvature, 1669.1266, 1e-3);
}

TEST(MoleculeUnions, OfAChargedMoleculeAgreeWithAlphaMol) {
  if (!std::filesystem::exists(kData / "mol")) GTEST_SKIP() << "no data in ../shared/data";
  const UnionOfBalls trace = union_of("mol/mol1_actin.pqr", {}, "CA", 0.0, 1.4, 377);
  EXPECT_NEAR(trace.area, 20747.02693537, 1e-6);
  EXPECT_NEAR(trace.volume, 48367.92696398, 1e-6);
  EXPECT_EQ(trace.euler, -64);
}

}  // namespace
}  // namespace orthoball
