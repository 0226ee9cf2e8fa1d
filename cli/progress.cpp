// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

Progress::Progress(ProgressMode mode, bool quiet)
    : is_shown_(!quiet && mode != ProgressMode::never &&
                (mode == ProgressMode::always || isatty(STDERR_FILENO) == 1)),
      is_overwritten_(mode == ProgressMode::automatic) {}

void Progress::begin(const std::string& name) {
  end();
  stage_ = name;
  start_ = std::chrono::steady_clock::now();
  if (is_shown_ && is_overwritten_) fmt::print(stderr, "\r\033[K{} ...", name);
  if (is_shown_) std::fflush(stderr);
}

void Progress::end() {
  if (stage_.empty()) return;
  if (is_shown_) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
    if (is_overwritten_) {
      fmt::print(stderr, "\r\033[K");
    } else {
      fmt::print(stderr, "orthoball: {}: {:.2f} s\n", stage_, taken.count());
    }
    std::fflush(stderr);
  }
  stage_.clear();
}
