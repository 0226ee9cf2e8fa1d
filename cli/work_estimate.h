// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// The parts of the work of a command, in their order.
enum class Stage {
  reading,
  triangulation,
  filtration,
  signatures,
  measuring,
  locating,
  pairing,
  finding_weights,
  writing_filter,
  writing_shape,
  writing_page
};

/// What it is called in messages: "triangulation", "writing".
[[nodiscard]] std::string_view name_of(Stage stage);

/// How far the work is and how long it will take, from what stages usually cost for so many sites,
/// corrected by what the stages that are over have cost here. All times in seconds.
class WorkEstimate {
 public:
  /// @param stages  those that will come.
  explicit WorkEstimate(std::vector<Stage> stages) : stages_(std::move(stages)) {}

  /// The input has so many bytes: enough for a guess before it is read.
  void expect_bytes(double bytes);
  void expect_sites(std::size_t sites, int dimension);
  void begin(Stage stage, double now);
  /// The stage counts its work: this share of it is done.
  void reach(double share) { reached_ = share; }
  void end(double now);

  /// A share of all work, and the time that is left; empty before anything is expected.
  struct Guess {
    double share;
    double seconds_left;
  };
  [[nodiscard]] std::optional<Guess> guess(double now) const;

 private:
  [[nodiscard]] double usual(Stage stage) const;

  std::vector<Stage> stages_;
  double sites_ = 0.0;
  int dimension_ = 3;
  std::optional<Stage> stage_;  // at hand
  double began_ = 0.0;
  std::optional<double> reached_;
  double spent_ = 0.0;            // on stages that are over
  double spent_here_ = 0.0;       // the same, but for reading
  double usual_until_now_ = 0.0;  // what those usually cost
};
