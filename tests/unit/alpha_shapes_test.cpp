// SPDX-License-Identifier: MIT
#include "orthoball/alpha_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/input/read.h"
#include "orthoball/signatures/signature.h"

namespace orthoball {
namespace {

TEST(AlphaShapes, TellWhichPartBegins) {
  std::vector<BuildStage> stages;
  const AlphaShapes shapes(WeightedPoints(2),
                           {.on_stage = [&](BuildStage stage) { stages.push_back(stage); }});
  EXPECT_EQ(stages, (std::vector{BuildStage::triangulation, BuildStage::filtration}));
  EXPECT_EQ(shapes.dimension(), 2);
}

TEST(AlphaShapes, AreTheSameWhateverTheNumberOfThreads) {
  const auto points = generators::points_of(generators::PointFamily::protein_like, 3, 3000, 1);
  const AlphaShapes one(points, {.threads = Threads(1)}), many(points, {.threads = Threads(4)});
  const auto& first = std::get<Filtration<3>>(one.filtration());
  const auto& second = std::get<Filtration<3>>(many.filtration());
  ASSERT_EQ(first.size(), second.size());
  EXPECT_TRUE(std::equal(first.spectrum().begin(), first.spectrum().end(),
                         second.spectrum().begin(), second.spectrum().end()));
  EXPECT_TRUE(std::equal(first.enters().begin(), first.enters().end(), second.enters().begin(),
                         second.enters().end()));
}

// Sanitizers keep what is freed.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && defined(__linux__)

double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages >> pages;
  return pages * 4096.0 / 1e6;
}

TEST(AlphaShapes, OfAHundredMoleculesOneAfterTheOtherLeaveNoMemoryBehind) {
  const std::string folder = std::string(ORTHOBALL_SOURCE_DIR) + "/examples/data/";
  double early = 0.0;
  std::size_t simplices = 0;
  for (int i = 0; i < 100; ++i) {
    const bool is_large = i % 10 == 0;
    Reading reading = read(folder + (is_large ? "bdna_dodecamer.pdb" : "c60.xyz"), {});
    const AlphaShapes shapes(std::move(reading.points));
    const auto& filtration = std::get<Filtration<3>>(shapes.filtration());
    scan_signatures<3>(filtration, [](const Signature<3>&) {});
    simplices += filtration.size();
    if (i == 20) early = resident_megabytes();
  }
  EXPECT_GT(simplices, 100'000U);
  EXPECT_LT(resident_megabytes(), early + 2.0);
}

#endif

}  // namespace
}  // namespace orthoball
