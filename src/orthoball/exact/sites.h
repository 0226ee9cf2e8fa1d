// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// A site as the double stages of the predicates read it: 32 bytes in space, one half cache line.
template <int D>
struct alignas(D == 3 ? 32 : 8) Site {
  double x[std::size_t{D}];
  double weight;
};

/// A site as the exact stages read it: every number is what it is.
template <int D>
struct ExactSite {
  double x[std::size_t{D}];
  double weight_high;  ///< weight = (weight_high + weight_low) * 2^weight_exponent
  double weight_low;
  int weight_exponent;
};

/// Sites prepared for the predicates, in an order chosen by the caller (the inside numbering).
///
/// The double stages read `operator[]`: coordinates and weight times one power of two (their square
/// for weights), chosen so that nothing over- or underflows harmfully (kLargestMagnitude) and,
/// where it can be, so that every number is an integer. They may differ from the truth: coordinates
/// by less than 2^-1074, weights by `weight_error()`. The exact stages read `exact`, which is the
/// truth.
///
/// Costs 8 (D + 1) + 4 bytes a site, 8 (D + 3) more where a double cannot hold every number
/// exactly.
template <int D>
class Sites {
 public:
  Sites() = default;
  /// @param rows  the sites taken, in their inside order. The unit is that of all points.
  Sites(const WeightedPoints& points, std::vector<SiteId> rows, Threads threads = Threads(1));

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Approximate where is_exact() is false, as said above. One record follows the last site, for
  /// the vertex at infinity of a triangulation at work: so far away that no filter decides about
  /// it.
  [[nodiscard]] const Site<D>& operator[](std::size_t site) const { return sites_[site]; }
  [[nodiscard]] std::span<const Site<D>> span() const { return {sites_.data(), size()}; }
  [[nodiscard]] ExactSite<D> exact(std::size_t site) const;

  /// The input row of a site.
  [[nodiscard]] SiteId row(std::size_t site) const { return rows_[site]; }
  [[nodiscard]] std::span<const SiteId> rows() const { return rows_; }

  /// Every number of every Site is exact.
  [[nodiscard]] bool is_exact() const { return exact_.empty(); }
  /// Every Site holds exact integers of at most 2^53: small determinants are exact in doubles.
  [[nodiscard]] bool is_integral() const { return is_integral_; }
  /// All weights are equal: no site can be hidden, no vertex attached.
  [[nodiscard]] bool is_unweighted() const { return is_unweighted_; }
  /// Largest |true weight - weight| over all Sites, in their unit.
  [[nodiscard]] double weight_error() const { return weight_error_; }

  /// Lengths of Site are 2^scale_exponent() times lengths in the unit of the points.
  [[nodiscard]] int scale_exponent() const { return scale_exponent_; }
  /// Lengths of ExactSite are 2^exact_scale_exponent() times lengths in the unit of the points.
  [[nodiscard]] int exact_scale_exponent() const { return is_exact() ? scale_exponent_ : 0; }
  /// The unit of the points is 10^-decimals() input units (0 for doubles).
  [[nodiscard]] int decimals() const { return decimals_; }

  /// Removes the sites i with is_dropped[i]; the others keep their order.
  void drop(const std::vector<bool>& is_dropped);
  /// The same sites with coordinate axes[i] as coordinate i.
  [[nodiscard]] Sites with_axes(const std::array<int, std::size_t{D}>& axes) const;

 private:
  void end_far_away();

  RawVector<Site<D>> sites_;         // and one more, see operator[]; empty without sites
  std::vector<ExactSite<D>> exact_;  // empty where sites_ are exact
  std::vector<SiteId> rows_;
  double weight_error_ = 0.0;
  int scale_exponent_ = 0;
  int decimals_ = 0;
  bool is_integral_ = true;
  bool is_unweighted_ = true;
};

/// Scaled coordinates and square roots of weights are below this: no product of five lengths, and
/// no sum of a thousand of them, leaves the double range.
inline constexpr double kLargestMagnitude = 0x1p+150;

extern template class Sites<2>;
extern template class Sites<3>;

}  // namespace orthoball
