// SPDX-License-Identifier: MIT
#pragma once

#include <malloc.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/inputs.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball::benchmarks {

/// One timed piece of work on an input, as the command line of a benchmark program names it:
/// `WORK FAMILY DIMENSION COUNT [THREADS]`. The same arguments make the same input in every
/// program.
///
///   input          nothing: what a process costs before its work begins
///   triangulation  from points to the cells of the regular triangulation
///   filtration     from points to all simplices in exact order
///   persistence    from points to the persistence pairs of all dimensions, in the stage `pairs`
///   signatures     from points to all signatures with Betti numbers at every index
struct Case {
  std::string work;
  WeightedPoints points;
  unsigned threads = 1;
};

/// @throws std::invalid_argument for other arguments.
inline Case case_of(int argc, char** argv) {
  if (argc != 5 && argc != 6) {
    throw std::invalid_argument("usage: WORK FAMILY DIMENSION COUNT [THREADS]");
  }
  return {argv[1],
          input(argv[2], std::atoi(argv[3]), static_cast<std::size_t>(std::atoll(argv[4]))),
          argc == 6 ? static_cast<unsigned>(std::atoi(argv[5])) : 1};
}

/// The weight of a row as peers take it: in the units of the arrays, rounded where it is no double.
inline double weight(const WeightedPoints& points, std::size_t row) {
  if (points.weight_kind() == WeightKind::none) return 0.0;
  const double number = points.weights()[row];
  return points.weight_kind() == WeightKind::radius ? number * std::abs(number) : number;
}

/// A line such as `VmHWM:  1024 kB` of /proc/self/status, in megabytes; 0 where there is none.
inline double status_megabytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word) {
    if (word == name + ":" && status >> kilobytes) return kilobytes / 1024.0;
  }
  return 0.0;
}

/// Seconds of processor time since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
  }

 private:
  std::clock_t start_ = std::clock();
};

/// Measures a work from where it is made to where it is asked: seconds of the processor (of all
/// threads) and of the clock, and memory.
class Meter {
 public:
  Meter() {
    malloc_trim(0);                               // of what the making of the input left
    std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins here
    start_megabytes_ = status_megabytes("VmRSS");
    start_ = std::clock();
    wall_start_ = Clock::now();
  }

  /// Ends a stage of the work: what its seconds, of the processor and of the clock, are called in
  /// the report.
  void stage(const std::string& name) { stages_.push_back({name, seconds(), wall_seconds()}); }

  /// The result as one line of JSON. `counts` are what programs must agree on where they have them
  /// in common.
  void report(const Case& task,
              const std::vector<std::pair<std::string, std::size_t>>& counts) const {
    const double seconds = this->seconds();
    const double wall = wall_seconds();
    const double peak = status_megabytes("VmHWM");
    std::cout << "{\"seconds\": " << seconds << ", \"wall\": " << wall << ", \"peak_mb\": " << peak
              << ", \"own_mb\": " << peak - start_megabytes_ << ", \"threads\": " << task.threads
              << ", \"input\": \"" << fingerprint(task.points) << '"';
    write_stages("stages", &Stage::seconds);
    write_stages("wall_stages", &Stage::wall_seconds);
    std::cout << ", \"counts\": {";
    const char* comma = "";
    for (const auto& [name, count] : counts) {
      std::cout << comma << '"' << name << "\": " << count;
      comma = ", ";
    }
    std::cout << "}}" << std::endl;
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Stage {
    std::string name;
    double seconds;  // both since the work began
    double wall_seconds;
  };

  void write_stages(const char* key, double Stage::*time) const {
    std::cout << ", \"" << key << "\": {";
    double before = 0.0;
    for (const Stage& stage : stages_) {
      std::cout << (before == 0.0 ? "" : ", ") << '"' << stage.name
                << "\": " << stage.*time - before;
      before = stage.*time;
    }
    std::cout << '}';
  }
  [[nodiscard]] double seconds() const {
    return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
  }
  [[nodiscard]] double wall_seconds() const {
    return std::chrono::duration<double>(Clock::now() - wall_start_).count();
  }

  double start_megabytes_ = 0.0;
  std::clock_t start_ = 0;
  Clock::time_point wall_start_;
  std::vector<Stage> stages_;
};

}  // namespace orthoball::benchmarks
