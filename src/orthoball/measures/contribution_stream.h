// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/contributions.h"

namespace orthoball {

/// The contributions of all simplices of one dimension in filter order, made window by window.
///
/// Neighbours in the filter are far apart in space and in memory. So the simplices of a window
/// (kWindow of them) are grouped by their numbers, measured group by group, and the results put in
/// filter order. At most (16 + size of a contribution) bytes times kWindow.
template <int D, class Contribution>
class ContributionStream {
 public:
  static constexpr std::size_t kWindow = std::size_t{1} << 20U;

  /// Keeps a reference to the filtration.
  ContributionStream(const Filtration<D>& filtration, const Contributions<D>& contributions,
                     int dimension);

  /// The contribution of the next simplex. Undefined after the last.
  [[nodiscard]] const Contribution& next() {
    if (next_ == window_.size()) fill_window();
    return window_[next_++];
  }

 private:
  void fill_window();

  const Filtration<D>* filtration_;
  Contributions<D> contributions_;
  std::uint32_t first_, count_;        // the simplices of the dimension
  std::size_t position_ = 0;           // in the filter, behind the window
  std::vector<Contribution> window_;   // in filter order
  std::size_t next_ = 0;               // in window_
  std::vector<std::uint32_t> wanted_;  // the simplices of the window in filter order
  std::vector<Placed> grouped_;        // the same, neighbours together
};

extern template class ContributionStream<2, CellContribution<2>>;
extern template class ContributionStream<2, FacetContribution>;
extern template class ContributionStream<2, EdgeContribution>;
extern template class ContributionStream<3, CellContribution<3>>;
extern template class ContributionStream<3, FacetContribution>;
extern template class ContributionStream<3, EdgeContribution>;

}  // namespace orthoball
