// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/measure_scan.h"
#include "orthoball/parallel.h"
#include "orthoball/signatures/role_counts.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/topology/betti.h"

namespace orthoball {

/// The signatures of a filtration, one run of indices after the other, each in blocks.
template <int D>
class SignatureScan {
 public:
  static constexpr std::uint32_t kBlock = 128;

  /// Begins before index 0. Keeps a reference to the filtration.
  SignatureScan(const Filtration<D>& filtration, Threads threads);

  /// Goes on to the next run, the first of which begins with index 0; false behind the last.
  bool next();

  [[nodiscard]] std::uint32_t first_index() const { return measures_.first_index(); }
  [[nodiscard]] std::uint32_t end_index() const { return measures_.end_index(); }

  /// Writes the signatures of a block of the run, at most kBlock of them, from index
  /// first_index() + block * kBlock on; returns how many. May be called by several threads.
  [[nodiscard]] std::size_t read(std::size_t block, std::span<Signature<D>> out) const;
  [[nodiscard]] std::size_t block_count() const { return blocks_.size(); }

 private:
  // What changes from one index to another.
  struct Step {
    RoleChanges<D> roles;
    std::uint32_t joining = 0, opening = 0, closing = 0;
  };
  struct State {
    RoleCounts<D> roles;
    std::uint32_t joined = 0, voids = 0;

    [[gnu::always_inline]] void advance(const Step& step) {
      roles.advance(step.roles);
      joined += step.joining;
      voids += step.opening - step.closing;
    }
  };
  // How many simplices change in one way at each index of the run.
  using Column = std::vector<std::uint32_t>;
  struct OwnColumns {
    Column vertices;  // enter
    std::array<Column, std::size_t{D} - 1> regular, interior;
    Column joining, opening, closing;
  };
  struct Changes {
    std::array<const std::uint32_t*, std::size_t{D} + 1> entering{};
    std::array<const std::uint32_t*, std::size_t{D} - 1> regular{};
    std::array<const std::uint32_t*, std::size_t{D}> interior{};
    const std::uint32_t *joining = nullptr, *opening = nullptr, *closing = nullptr;

    // The step that `take` finds in each column.
    template <class Take>
    [[nodiscard, gnu::always_inline]] Step step(const Take& take) const {
      Step result;
      for (std::size_t k = 0; k < entering.size(); ++k)
        result.roles.entering[k] = take(entering[k]);
      for (std::size_t k = 0; k < regular.size(); ++k) result.roles.regular[k] = take(regular[k]);
      for (std::size_t k = 0; k < interior.size(); ++k)
        result.roles.interior[k] = take(interior[k]);
      result.joining = take(joining);
      if constexpr (D == 3) {
        result.opening = take(opening);
        result.closing = take(closing);
      }
      return result;
    }
  };

  void count_changes();

  const Filtration<D>& filtration_;
  Threads threads_;
  FacetRoles<D> roles_;
  IndexCounts joining_;
  VoidCounts voids_;
  IndexCounts vertices_;                                       // enter
  std::array<RoleChangeCounts<D>, std::size_t{D} - 1> lower_;  // below the facets
  MeasureScan<D> measures_;
  OwnColumns own_;
  Changes changes_;
  std::vector<Step> steps_;    // [block]
  std::vector<State> blocks_;  // [block]: before it
  State end_;                  // at the end of the run
};

extern template class SignatureScan<2>;  // defined in signature_scan.cpp
extern template class SignatureScan<3>;

}  // namespace orthoball
