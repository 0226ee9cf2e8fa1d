// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball::benchmarks {

/// One timed piece of work on a family of points, as the command line of a benchmark program names
/// it: `WORK FAMILY DIMENSION COUNT`. The same arguments make the same input in every program.
struct Case {
  std::string work;  ///< triangulation, or signatures: everything from points to all signatures
  WeightedPoints points;
};

/// The case that the arguments name, its rows in random order.
/// @throws std::invalid_argument for other arguments.
inline Case case_of(int argc, char** argv) {
  if (argc != 5) throw std::invalid_argument("usage: WORK FAMILY DIMENSION COUNT");
  const int dimension = std::atoi(argv[3]);
  const auto count = static_cast<std::size_t>(std::atoll(argv[4]));
  constexpr std::uint64_t kSeed = 1;
  for (const generators::PointFamily family : generators::point_families()) {
    if (std::string(generators::name(family)) != argv[2]) continue;
    const WeightedPoints points = generators::points_of(family, dimension, count, kSeed);
    const std::vector<std::uint32_t> order = generators::random_permutation(count, kSeed);
    return {argv[1], generators::with_rows(points, order)};
  }
  throw std::invalid_argument(std::string("no family ") + argv[2]);
}

/// Seconds of processor time since it was made: all programs here have one thread, and busy
/// neighbours do not count.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
  }

 private:
  std::clock_t start_ = std::clock();
};

/// Largest resident memory of this process so far, in megabytes.
inline double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// The result as one line of JSON. `result` is a count that peers must agree on.
inline void report(double seconds, std::size_t result) {
  std::cout << "{\"seconds\": " << seconds << ", \"peak_mb\": " << peak_megabytes()
            << ", \"result\": " << result << "}" << std::endl;
}

}  // namespace orthoball::benchmarks
