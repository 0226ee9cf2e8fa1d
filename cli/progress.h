// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/work_estimate.h"

/// When progress is shown.
enum class ProgressMode {
  automatic,  ///< where standard error is a terminal and the work takes more than a second
  never,
  always,  ///< one line for every stage
};

/// Tells on standard error what the program is doing: on a terminal in one line that is overwritten
/// while the work goes on, with the share that is done and the time left, and cleared at the end;
/// otherwise a line per stage with its seconds.
///
/// The line is drawn by a thread that sleeps most of the time and exists on terminals only: the
/// work never waits for it.
class Progress {
 public:
  /// @param stages  of the command, in their order.
  Progress(ProgressMode mode, bool quiet, std::vector<Stage> stages);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// What is known of the input, for estimates.
  void expect_file(const std::string& path);
  void expect_sites(std::size_t sites, int dimension);
  /// The stage before ends, `stage` begins.
  void begin(Stage stage);
  /// Of the stage at hand `done` of `all` steps are done. Cheap: most calls return at once.
  void reach(std::size_t done, std::size_t all) {
    if (is_drawn_ && done % 4096 == 0)
      reach_share(static_cast<double>(done) / static_cast<double>(all));
  }
  /// The last stage ends.
  void end();
  /// What is being done, in words; empty between stages.
  [[nodiscard]] std::string stage() const;

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] double now() const;
  void reach_share(double share);
  void draw_until_stopped();

  bool is_shown_;
  bool is_drawn_;
  Clock::time_point start_ = Clock::now();
  double began_ = 0.0;

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable stopping_;
  bool is_stopping_ = false;
  bool has_line_ = false;  // on the terminal
  double shown_share_ = 0.0;
  std::optional<Stage> stage_;
  WorkEstimate estimate_;
  std::thread drawer_;
};
