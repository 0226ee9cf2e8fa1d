// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace {

constexpr auto kFirst = std::chrono::milliseconds(1000);  // shorter work shows nothing
constexpr auto kNext = std::chrono::milliseconds(250);

// "about 12 s left", in steps that do not flicker.
std::string time_text(double seconds) {
  if (seconds < 1.5) return "nearly done";
  if (seconds < 90.0) return fmt::format("about {:.0f} s left", seconds);
  if (seconds < 5400.0) return fmt::format("about {:.0f} min left", seconds / 60.0);
  return fmt::format("about {:.1f} h left", seconds / 3600.0);
}

}  // namespace

Progress::Progress(ProgressMode mode, bool quiet, std::vector<Stage> stages)
    : is_shown_(!quiet && mode == ProgressMode::always),
      is_drawn_(!quiet && mode == ProgressMode::automatic && isatty(STDERR_FILENO) == 1),
      estimate_(std::move(stages)) {
  if (is_drawn_) drawer_ = std::thread([this] { draw_until_stopped(); });
}

Progress::~Progress() {
  end();
  if (!drawer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
  }
  stopping_.notify_one();
  drawer_.join();
}

void Progress::expect_file(const std::string& path) {
  if (!is_drawn_) return;
  std::error_code no_size;
  const auto bytes = std::filesystem::file_size(path, no_size);
  if (no_size) return;
  const std::lock_guard lock(mutex_);
  estimate_.expect_bytes(static_cast<double>(bytes));
}

void Progress::expect_sites(std::size_t sites, int dimension) {
  const std::lock_guard lock(mutex_);
  estimate_.expect_sites(sites, dimension);
}

void Progress::begin(Stage stage) {
  end();
  const std::lock_guard lock(mutex_);
  stage_ = stage;
  began_ = now();
  estimate_.begin(stage, began_);
}

void Progress::end() {
  const std::lock_guard lock(mutex_);
  if (!stage_) return;
  estimate_.end(now());
  if (is_shown_) {
    fmt::print(stderr, "orthoball: {}: {:.2f} s\n", name_of(*stage_), now() - began_);
  }
  if (has_line_) fmt::print(stderr, "\r\033[K");
  has_line_ = false;
  stage_.reset();
}

std::string Progress::stage() const {
  const std::lock_guard lock(mutex_);
  return stage_ ? std::string(name_of(*stage_)) : std::string();
}

double Progress::now() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::reach_share(double share) {
  const std::lock_guard lock(mutex_);
  estimate_.reach(share);
}

void Progress::draw_until_stopped() {
  std::unique_lock lock(mutex_);
  auto wait = kFirst;
  while (!stopping_.wait_for(lock, wait, [this] { return is_stopping_; })) {
    wait = kNext;
    if (!stage_) continue;
    const auto guess = estimate_.guess(now());
    if (guess) shown_share_ = std::max(shown_share_, guess->share);  // never back
    fmt::print(stderr, "\r\033[K{}{}", name_of(*stage_),
               guess ? fmt::format(", {:.0f} % done, {}", std::floor(100.0 * shown_share_),
                                   time_text(guess->seconds_left))
                     : " ...");
    has_line_ = true;
  }
}
