// SPDX-License-Identifier: MIT
// What a small input costs, stage by stage: `pipeline_small FILE` does all of it a hundred times
// and prints the best of each stage in milliseconds, and the memory after 20 and after 100 times.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "orthoball/filtration/filtration.h"
#include "orthoball/input/read.h"
#include "orthoball/signatures/notable_alphas.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"

namespace {

using namespace orthoball;

constexpr std::array kStages = {"reading", "triangulation", "filtration", "signatures",
                                "notable alphas"};

double milliseconds(std::clock_t ticks) {
  return 1e3 * static_cast<double>(ticks) / CLOCKS_PER_SEC;
}

double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages >> pages;
  return pages * 4096.0 / 1e6;
}

template <int D>
std::size_t run(const WeightedPoints& points, const auto& lap) {
  RegularTriangulation<D> triangulation = regular_triangulation<D>(points);
  lap();
  const Filtration<D> filtration(std::move(triangulation));
  lap();
  std::size_t last = 0;
  scan_signatures<D>(filtration, [&](const Signature<D>& s) { last = s.index; });
  lap();
  last += notable_alphas(filtration).size();
  lap();
  return last;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) throw std::invalid_argument("usage: FILE");
  std::array<double, kStages.size()> best;  // processor milliseconds: neighbours do not count
  best.fill(1e300);
  double early = 0.0, whole = 1e300;
  std::size_t sites = 0, result = 0;
  for (int turn = 0; turn < 100; ++turn) {
    const std::clock_t start = std::clock();
    std::clock_t before = start;
    std::size_t stage = 0;
    const auto lap = [&] {
      const std::clock_t now = std::clock();
      best[stage] = std::min(best[stage], milliseconds(now - before));
      ++stage;
      before = now;
    };
    const Reading reading = read(argv[1], {});
    lap();
    sites = reading.points.size();
    result +=
        reading.points.dimension() == 2 ? run<2>(reading.points, lap) : run<3>(reading.points, lap);
    whole = std::min(whole, milliseconds(before - start));
    if (turn == 19) early = resident_megabytes();
  }
  std::string text = fmt::format("{{\"sites\": {}, \"result\": {}", sites, result);
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    text += fmt::format(", \"{}\": {:.3f}", kStages[i], best[i]);
  }
  std::cout << fmt::format(
      "{}, \"all\": {:.3f}, \"mb_after_20\": {:.1f}, \"mb_after_100\": {:.1f}}}\n", text, whole,
      early, resident_megabytes());
}
