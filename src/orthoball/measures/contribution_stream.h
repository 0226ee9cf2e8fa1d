// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/contributions.h"

namespace orthoball {

/// The contributions of all simplices of one dimension in filter order, made window by window.
///
/// Neighbours in the filter are far apart in space and in memory, and the other way round. So the
/// simplices of a window (kWindow of them) are grouped by their numbers and measured group by
/// group; the results are dealt out to stretches of the filter (kStretch of them), and each of
/// these is put in order when it is reached, in the processor's caches. At most (14 + size of a
/// contribution) bytes times kWindow.
template <int D, class Contribution>
class ContributionStream {
 public:
  static constexpr std::size_t kWindow = std::size_t{1} << 20U;
  static constexpr std::size_t kStretch = std::size_t{1} << 13U;

  /// Keeps a reference to the filtration.
  ContributionStream(const Filtration<D>& filtration, const Contributions<D>& contributions,
                     int dimension);

  /// The contribution of the next simplex. Undefined after the last.
  [[nodiscard]] const Contribution& next() {
    if (next_ == stretch_.size()) fill_stretch();
    return stretch_[next_++];
  }

 private:
  // A simplex of the window, as a number in its dimension, and its place among those in filter
  // order.
  struct Placed {
    std::uint32_t number, place;
  };

  void fill_window();
  void group(std::span<const std::uint32_t> numbers);
  void measure_groups();
  void fill_stretch();

  const Filtration<D>* filtration_;
  Contributions<D> contributions_;
  std::uint32_t first_, count_;         // the simplices of the dimension
  std::size_t position_ = 0;            // in the filter, behind the window
  std::vector<Placed> grouped_;         // the window, neighbours together
  std::vector<Contribution> measured_;  // stretch after stretch, in any order within
  std::vector<std::uint16_t> place_;    // of measured_ in its stretch
  std::size_t stretch_begin_ = 0;       // in measured_, behind the stretch at hand
  std::vector<Contribution> stretch_;   // in filter order
  std::size_t next_ = 0;                // in stretch_
};

extern template class ContributionStream<2, CellContribution<2>>;
extern template class ContributionStream<2, FacetContribution>;
extern template class ContributionStream<2, EdgeContribution>;
extern template class ContributionStream<3, CellContribution<3>>;
extern template class ContributionStream<3, FacetContribution>;
extern template class ContributionStream<3, EdgeContribution>;

}  // namespace orthoball
