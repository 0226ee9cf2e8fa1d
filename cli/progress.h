// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

/// When progress is shown.
enum class ProgressMode {
  automatic,  ///< where standard error is a terminal and the work takes more than a moment
  never,
  always,  ///< one line for every stage
};

/// Tells on standard error what the program is doing: on a terminal in one line that is overwritten
/// and cleared at the end, otherwise a line per stage with its seconds.
class Progress {
 public:
  Progress(ProgressMode mode, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { end(); }

  /// The stage before ends, `name` begins: "reading", "triangulation".
  void begin(const std::string& name);
  /// The last stage ends.
  void end();

 private:
  bool is_shown_;
  bool is_overwritten_;
  std::string stage_;
  std::chrono::steady_clock::time_point start_;
};
