// SPDX-License-Identifier: MIT
#include "orthoball/queries/alpha_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "orthoball/filtration/alpha.h"
#include "orthoball/points/subsample.h"
#include "orthoball/queries/first_manifold.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

constexpr double kEndless = 2.0;         // the stability of a stretch without an end
constexpr double kPlateauGrowth = 1.05;  // of the volume on a plateau
constexpr double kLeastVolume = 0.01;    // of the convex hull's, where a plateau begins
constexpr double kMostVolume = 0.95;     // the same, and before a gap: later only slivers enter
constexpr double kLeastPlateau = 1.1;    // growth of the largest ball on a plateau
constexpr std::size_t kMostPlateaus = 3;
constexpr double kWaterRadius = 1.4;  // ångström

using MaybeIndex = std::optional<std::uint32_t>;

// Indices first <= i < end with the same Betti numbers.
template <int D>
struct Stretch {
  std::uint32_t first, end;
  BettiNumbers<D> betti;
};

// What one scan of the signatures tells of every index.
template <int D>
class Course {
 public:
  Course(const Filtration<D>& filtration, Threads threads)
      : filtration_(filtration),
        volume_(filtration.spectrum_size() + std::size_t{1}),
        is_smooth_(volume_.size()) {
    scan_signatures<D>(
        filtration, [&](const Signature<D>& at) { visit(at); }, threads);
  }

  [[nodiscard]] const std::vector<Stretch<D>>& stretches() const { return stretches_; }
  [[nodiscard]] const Stretch<D>& stretch(std::uint32_t index) const {
    return *std::prev(std::upper_bound(
        stretches_.begin(), stretches_.end(), index,
        [](std::uint32_t i, const Stretch<D>& stretch) { return i < stretch.first; }));
  }
  /// [index]: whether nothing is singular.
  [[nodiscard]] const std::vector<bool>& is_smooth() const { return is_smooth_; }

  // By how much the largest ball grows from one index to another.
  [[nodiscard]] double growth(std::uint32_t from, std::uint32_t to) const {
    if (to == filtration_.never()) return kEndless;
    return radius(from) > 0.0 && std::isfinite(radius(to)) ? radius(to) / radius(from) : 1.0;
  }
  // The last index before `to` at which it has grown no more than half of that, in ratios.
  [[nodiscard]] std::uint32_t middle(std::uint32_t from, std::uint32_t to) const {
    const double half = std::sqrt(radius(from)) * std::sqrt(radius(to));
    std::uint32_t low = from, high = to;  // radius(low) <= half
    while (high - low > 1) {
      const std::uint32_t between = low + (high - low) / 2;
      (radius(between) <= half ? low : high) = between;
    }
    return low;
  }
  [[nodiscard]] MaybeIndex signature(std::uint32_t all_vertices) const;
  [[nodiscard]] MaybeIndex spectrum_gap(std::uint32_t all_vertices) const;
  [[nodiscard]] std::vector<std::uint32_t> plateaus() const;

 private:
  void visit(const Signature<D>& at) {
    volume_[at.index] = at.volume;
    std::uint64_t singular = 0;
    for (const std::uint32_t of_dimension : at.singular) singular += of_dimension;
    is_smooth_[at.index] = singular == 0;
    if (stretches_.empty() || stretches_.back().betti != at.betti) {
      if (!stretches_.empty()) stretches_.back().end = at.index;
      stretches_.push_back({at.index, filtration_.never(), at.betti});
    }
  }
  // Two near points among many far ones make a long stretch in which nothing is seen.
  [[nodiscard]] bool is_dust(const Stretch<D>& stretch) const {
    return stretch.betti[0] > filtration_.count(0) / 2;
  }
  [[nodiscard]] bool is_nearly_full(std::uint32_t index) const {
    return volume_.back() > 0.0 && volume_[index] > kMostVolume * volume_.back();
  }
  [[nodiscard]] double radius(std::uint32_t index) const {
    const double alpha2 = filtration_.alpha2(index) - filtration_.alpha2(1);
    return std::sqrt(std::max(0.0, alpha2));
  }

  const Filtration<D>& filtration_;
  std::vector<Stretch<D>> stretches_;
  std::vector<double> volume_;  // [index]
  std::vector<bool> is_smooth_;
};

template <int D>
MaybeIndex Course<D>::signature(std::uint32_t all_vertices) const {
  MaybeIndex best;
  double longest = 1.0;
  for (const Stretch<D>& stretch : stretches_) {
    const std::uint32_t first = std::max(stretch.first, all_vertices);
    if (stretch.end == filtration_.never() || stretch.end <= first) continue;
    if (is_dust(stretch) || !(growth(first, stretch.end) > longest)) continue;
    longest = growth(first, stretch.end);
    best = middle(first, stretch.end);
  }
  return best;
}

template <int D>
MaybeIndex Course<D>::spectrum_gap(std::uint32_t all_vertices) const {
  MaybeIndex best;
  double widest = 1.0;
  for (std::uint32_t index = all_vertices; index < filtration_.spectrum_size(); ++index) {
    if (is_nearly_full(index)) break;
    if (!(growth(index, index + 1) > widest) || is_dust(stretch(index))) continue;
    widest = growth(index, index + 1);
    best = index;
  }
  return best;
}

// Of every index the stretch on which the volume stays about as it is there; the longest of these,
// then the longest that it leaves.
template <int D>
std::vector<std::uint32_t> Course<D>::plateaus() const {
  struct Plateau {
    double growth;
    std::uint32_t first, end;
  };
  std::vector<Plateau> all;
  std::uint32_t end = 1;
  for (std::uint32_t first = 1; first <= filtration_.spectrum_size(); ++first) {
    end = std::max(end, first);
    while (end < filtration_.never() && volume_[end] <= kPlateauGrowth * volume_[first]) ++end;
    if (end == filtration_.never()) break;
    if (volume_[first] < kLeastVolume * volume_.back() || volume_[first] <= 0.0) continue;
    if (is_nearly_full(first)) break;
    if (growth(first, end) >= kLeastPlateau) all.push_back({growth(first, end), first, end});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Plateau& a, const Plateau& b) { return a.growth > b.growth; });
  std::vector<Plateau> taken;
  std::vector<std::uint32_t> result;
  for (const Plateau& one : all) {
    if (taken.size() == kMostPlateaus) break;
    const bool is_free = std::none_of(taken.begin(), taken.end(), [&](const Plateau& other) {
      return one.first < other.end && other.first < one.end;
    });
    if (!is_free) continue;
    taken.push_back(one);
    result.push_back(middle(one.first, one.end));
  }
  return result;
}

template <int D>
NotableAlpha named(const Filtration<D>& filtration, std::string name, std::string reason,
                   MaybeIndex index) {
  const double alpha2 = index ? filtration.alpha2(*index) : 0.0;
  return {std::move(name), std::move(reason), index, alpha2, alpha_from_alpha2(alpha2)};
}

const char* const kSignatureReason =
    "the middle of the stretch on which the topology lasts longest";
const char* const kGapReason = "no simplex enters for longest";
const char* const kManifoldReason =
    "first whose surface is a closed manifold with every vertex in its cells, nothing singular";

template <int D>
std::vector<NotableAlpha> all_alphas(const Filtration<D>& filtration, const Course<D>& course,
                                     WeightMeaning weights) {
  const std::vector<NotableAlpha> notables = notable_alphas(filtration);
  const MaybeIndex all_vertices = notables[0].index, covered = notables[1].index;
  std::vector<NotableAlpha> alphas;
  const auto if_there = [&](const auto& find) -> MaybeIndex {
    return all_vertices ? find(*all_vertices) : MaybeIndex();
  };
  const auto add = [&](const char* name, const char* reason, MaybeIndex index) {
    alphas.push_back(named(filtration, name, reason, index));
  };
  add("signature", kSignatureReason,
      if_there([&](std::uint32_t from) { return course.signature(from); }));
  alphas.insert(alphas.end(), notables.begin(), notables.end());
  const auto plateaus = course.plateaus();
  for (std::size_t i = 0; i < plateaus.size(); ++i) {
    add(("plateau_" + std::to_string(i + 1)).c_str(),
        "in the middle of a stretch on which the volume hardly grows", plateaus[i]);
  }
  add("spectrum_gap", kGapReason,
      if_there([&](std::uint32_t from) { return course.spectrum_gap(from); }));
  add("manifold", kManifoldReason,
      covered ? first_manifold(filtration, *covered, course.is_smooth()) : MaybeIndex());
  if (weights == WeightMeaning::molecule_radii && filtration.spectrum_size() > 0) {
    const double probe = kWaterRadius * kWaterRadius;
    alphas.push_back({"dual_complex", "the molecule itself: weights are the radii of its atoms",
                      filtration.index(0.0), 0.0, 0.0});
    alphas.push_back(
        {"probe",
         "as large as a water molecule, 1.4 (not a probe of 1.4, which is added to the radii)",
         filtration.index(probe), probe, kWaterRadius});
  }
  return alphas;
}

// The quartiles, by nearest rank; sorts.
std::array<double, 3> quartiles(std::vector<double>& numbers) {
  if (numbers.empty()) return {};
  std::sort(numbers.begin(), numbers.end());
  std::array<double, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = numbers[((i + 1) * numbers.size() + 3) / 4 - 1];
  }
  return result;
}

}  // namespace

template <int D>
std::vector<AlphaCandidate<D>> alpha_candidates(const Filtration<D>& filtration,
                                                WeightMeaning weights, Threads threads) {
  const Course<D> course(filtration, threads);
  std::vector<AlphaCandidate<D>> result;
  std::vector<std::uint32_t> indices;
  for (NotableAlpha& alpha : all_alphas(filtration, course, weights)) {
    AlphaCandidate<D> candidate;
    candidate.alpha = std::move(alpha);
    const std::uint32_t index = candidate.alpha.index.value_or(0);
    if (index > 0) {
      const Stretch<D>& stretch = course.stretch(index);
      candidate.stable_from = stretch.first;
      candidate.stable_to = stretch.end;
      candidate.stability = course.growth(stretch.first, stretch.end);
    }
    indices.push_back(index);
    result.push_back(std::move(candidate));
  }
  const auto at = signatures<D>(filtration, indices, threads);
  for (std::size_t i = 0; i < at.size(); ++i) result[i].at = at[i];
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return std::pair(!a.alpha.index, -a.stability) < std::pair(!b.alpha.index, -b.stability);
  });
  return result;
}

std::vector<std::string> candidate_names(int dimension) {
  std::vector<std::string> names{
      "all_vertices", "all_vertices_in_cells", "connected", "one_region", "solid", "solid_from"};
  for (int k = 0; k < dimension; ++k) names.push_back("gap_" + std::to_string(k));
  names.emplace_back("signature");
  for (std::size_t i = 1; i <= kMostPlateaus; ++i) names.push_back("plateau_" + std::to_string(i));
  for (const char* name : {"spectrum_gap", "manifold", "dual_complex", "probe"}) {
    names.emplace_back(name);
  }
  return names;
}

template <int D>
std::vector<AlphaSpread> alpha_spreads(const WeightedPoints& points,
                                       std::span<const AlphaCandidate<D>> candidates,
                                       WeightMeaning weights, const ResampleOptions& options,
                                       Threads threads) {
  std::vector<AlphaSpread> result(candidates.size());
  std::vector<std::vector<double>> alphas(candidates.size());
  for (std::uint32_t i = 0; i < options.count; ++i) {
    const Filtration<D> filtration(
        regular_triangulation<D>(
            subsample(points, options.share, options.seed * 0x9E3779B97F4A7C15U + i)),
        threads);
    const auto found = alpha_candidates(filtration, weights, threads);
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const auto same = std::find_if(found.begin(), found.end(), [&](const auto& other) {
        return other.alpha.index && other.alpha.name == candidates[c].alpha.name;
      });
      if (same == found.end()) continue;
      ++result[c].found;
      if (same->at.betti == candidates[c].at.betti) ++result[c].same_betti;
      alphas[c].push_back(same->alpha.alpha);
    }
  }
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto [low, median, high] = quartiles(alphas[c]);
    result[c].low = low;
    result[c].median = median;
    result[c].high = high;
  }
  return result;
}

template std::vector<AlphaCandidate<2>> alpha_candidates<2>(const Filtration<2>&, WeightMeaning,
                                                            Threads);
template std::vector<AlphaCandidate<3>> alpha_candidates<3>(const Filtration<3>&, WeightMeaning,
                                                            Threads);
template std::vector<AlphaSpread> alpha_spreads<2>(const WeightedPoints&,
                                                   std::span<const AlphaCandidate<2>>,
                                                   WeightMeaning, const ResampleOptions&, Threads);
template std::vector<AlphaSpread> alpha_spreads<3>(const WeightedPoints&,
                                                   std::span<const AlphaCandidate<3>>,
                                                   WeightMeaning, const ResampleOptions&, Threads);

}  // namespace orthoball
