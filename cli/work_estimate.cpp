// SPDX-License-Identifier: MIT
#include "cli/work_estimate.h"

#include <algorithm>
#include <cmath>

namespace {

// Nanoseconds a site, in space and in the plane, for a million sites on one core.
struct Cost {
  Stage stage;
  std::string_view name;
  double space;
  double plane;
};
constexpr std::array kCosts = {
    Cost{Stage::reading, "reading", 100, 70},
    Cost{Stage::triangulation, "triangulation", 2000, 480},
    Cost{Stage::filtration, "filtration", 2050, 290},
    Cost{Stage::signatures, "signatures", 2350, 420},
    Cost{Stage::measuring, "measuring", 7000, 4000},
    Cost{Stage::locating, "locating", 2000, 700},
    Cost{Stage::pairing, "pairing", 5000, 900},
    Cost{Stage::finding_weights, "finding weights", 8500, 1600},  // two filtrations at least
    Cost{Stage::writing_filter, "writing", 7700, 1550},
    Cost{Stage::writing_shape, "writing", 400, 200},
    Cost{Stage::writing_page, "writing", 30000, 5000},
};
constexpr double kBytesOfSite = 30.0;

const Cost& cost_of(Stage stage) {
  return *std::find_if(kCosts.begin(), kCosts.end(),
                       [&](const Cost& cost) { return cost.stage == stage; });
}

}  // namespace

std::string_view name_of(Stage stage) { return cost_of(stage).name; }

void WorkEstimate::expect_bytes(double bytes) { sites_ = bytes / kBytesOfSite; }

void WorkEstimate::expect_sites(std::size_t sites, int dimension) {
  sites_ = static_cast<double>(sites);
  dimension_ = dimension;
}

// Sorting and far memory make large inputs dearer a site.
double WorkEstimate::usual(Stage stage) const {
  const Cost& cost = cost_of(stage);
  const double each = dimension_ == 2 ? cost.plane : cost.space;
  return 1e-9 * each * sites_ * std::log2(sites_ + 2.0) / std::log2(1e6);
}

void WorkEstimate::begin(Stage stage, double now) {
  end(now);
  // What should have come before will not come any more.
  const auto planned = std::find(stages_.begin(), stages_.end(), stage);
  if (planned != stages_.end()) stages_.erase(stages_.begin(), planned);
  stage_ = stage;
  began_ = now;
}

void WorkEstimate::end(double now) {
  if (!stage_) return;
  spent_ += now - began_;
  if (*stage_ != Stage::reading) {  // which tells more of the device than of the processor
    spent_here_ += now - began_;
    usual_until_now_ += usual(*stage_);
  }
  const auto done = std::find(stages_.begin(), stages_.end(), *stage_);
  if (done != stages_.end()) stages_.erase(stages_.begin(), done + 1);
  stage_.reset();
  reached_.reset();
}

std::optional<WorkEstimate::Guess> WorkEstimate::guess(double now) const {
  if (sites_ <= 0.0) return std::nullopt;
  const double slowness = usual_until_now_ > 0.0 ? spent_here_ / usual_until_now_ : 1.0;
  const double here = stage_ ? now - began_ : 0.0;
  double left = 0.0;
  for (const Stage stage : stages_) {
    double part = slowness * usual(stage);
    if (stage == stage_) {
      // A stage that takes longer than it should is taken to be nearly done, and never done.
      part = std::max(part - here, 0.1 * here);
      if (reached_ && *reached_ > 0.02) part = here * (1.0 - *reached_) / *reached_;
    }
    left += part;
  }
  const double done = spent_ + here;
  return Guess{done / std::max(done + left, 1e-9), left};
}
