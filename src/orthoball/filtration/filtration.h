// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/bit_run.h"
#include "orthoball/filtration/critical_indices.h"
#include "orthoball/filtration/simplex_table.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// [k]: a number of simplices of dimension k, 0..D.
template <int D>
using ByDimension = std::array<std::uint32_t, static_cast<std::size_t>(D) + 1>;

/// What a simplex is at one index of the spectrum.
enum class Role { exterior, singular, regular, interior };

/// All alpha complexes of weighted points: when every simplex of the regular triangulation appears
/// as alpha2 grows, exactly. The simplices in that order are a Filter of it.
///
/// The spectrum alpha2_1 < ... < alpha2_s lists the exactly distinct values at which the complex
/// changes; index i in 1..s names the complex K_i, K_0 is empty. Every simplex has three indices:
/// `enters` <= `regular` <= `interior`, the last two `never()` where it never takes that role.
/// All comparisons are exact; only `alpha2(index)` is a number, correctly rounded.
///
/// Owns its triangulation. Immutable; any number of threads may read it. About 700 bytes a site in
/// space, its triangulation included; time linear in the simplices but for sorting.
/// @cite edelsbrunner_mucke_1994
template <int D>
class Filtration {
 public:
  Filtration() = default;  // of no sites
  /// The same on any number of threads.
  /// @throws LimitError as SimplexTable does.
  explicit Filtration(RegularTriangulation<D> triangulation, Threads threads = {});
  /// The complexes at some values of alpha2 alone, in half the time: all that is told of an index
  /// is exact, but the spectrum has these values and last infinity, where every simplex is there.
  /// At some of them nothing may happen.
  /// @param alpha2  ascending, finite; length^2 in input units.
  /// @throws LimitError as SimplexTable does; InputError for values that do not ascend.
  Filtration(RegularTriangulation<D> triangulation, std::span<const double> alpha2,
             Threads threads = {});

  [[nodiscard]] const RegularTriangulation<D>& triangulation() const { return triangulation_; }
  [[nodiscard]] const SimplexTable<D>& table() const { return table_; }

  // Simplices, numbered as in SimplexTable.

  [[nodiscard]] std::size_t size() const { return table_.size(); }
  [[nodiscard]] std::size_t count(int dimension) const { return table_.count(dimension); }
  [[nodiscard]] int dimension(SimplexId simplex) const { return table_.dimension(simplex); }
  /// The vertices by number, ascending.
  [[nodiscard]] FewOf<VertexId, D> vertices(SimplexId simplex) const {
    return table_.vertices(triangulation_, simplex);
  }
  /// The input rows of the vertices, ascending.
  [[nodiscard]] FewOf<SiteId, D> rows(SimplexId simplex) const;
  /// The faces one dimension down, facet i without vertices(simplex)[i]; none for a vertex.
  [[nodiscard]] FewOf<SimplexId, D> facets(SimplexId simplex) const {
    return table_.facets(triangulation_, simplex);
  }
  /// The one or two cells beside a simplex one dimension below affine_dimension().
  [[nodiscard]] FewOf<SimplexId, D> cells_beside(SimplexId facet) const {
    return table_.cells_beside(triangulation_, facet);
  }
  /// Whether some other site q has pi_q(centre) < squared orthoradius. Exact.
  [[nodiscard]] bool is_attached(SimplexId simplex) const {
    return bit_at(is_attached_.data(), simplex.row());
  }

  // The spectrum.

  /// s, the number of exactly distinct values.
  [[nodiscard]] std::uint32_t spectrum_size() const {
    return static_cast<std::uint32_t>(spectrum_.size());
  }
  /// [index - 1]: the double nearest to each value, length^2 in input units; never decreasing, two
  /// entries may share one. Infinite where a value is beyond the double range.
  [[nodiscard]] std::span<const double> spectrum() const { return spectrum_; }
  /// Label of an index in 1..s. Correctly rounded; length^2 in input units.
  [[nodiscard]] double alpha2(std::uint32_t index) const { return spectrum_[index - 1]; }
  /// The number of entries whose label is <= alpha2: a closed threshold. O(log s).
  [[nodiscard]] std::uint32_t index(double alpha2) const;
  /// s + 1, the index of what does not happen.
  [[nodiscard]] std::uint32_t never() const { return spectrum_size() + 1; }
  /// Whether the spectrum has given values instead of all: then nothing is known between them.
  [[nodiscard]] bool is_coarse() const { return is_coarse_; }

  // The three indices of a simplex.

  /// Index at which it joins the complex.
  [[nodiscard]] std::uint32_t enters(SimplexId simplex) const {
    return indices_.enters[simplex.row()];
  }
  /// Index at which its first proper coface joins: enters() for a D-simplex, never() for a simplex
  /// without cofaces where the sites span less than R^D.
  [[nodiscard]] std::uint32_t regular(SimplexId simplex) const {
    if (simplex.row() < indices_.roles.size()) return indices_.roles[simplex.row()].regular;
    const auto [cell, other] = entering_beside(simplex);
    return std::min(cell, other);
  }
  /// Index from which it is inside the shape: enters() for a D-simplex, never() on the convex hull
  /// and where the sites span less than R^D.
  [[nodiscard]] std::uint32_t interior(SimplexId simplex) const {
    if (simplex.row() < indices_.roles.size()) return indices_.roles[simplex.row()].interior;
    const auto [cell, other] = entering_beside(simplex);
    return std::max(cell, other);
  }
  /// Exact. Everything is exterior at index 0.
  [[nodiscard]] Role role(SimplexId simplex, std::uint32_t index) const {
    if (index < enters(simplex)) return Role::exterior;
    if (index < regular(simplex)) return Role::singular;
    return index < interior(simplex) ? Role::regular : Role::interior;
  }

  /// [simplex]: enters() of all, for loops over millions of them.
  [[nodiscard]] std::span<const std::uint32_t> enters() const { return indices_.enters; }

 private:
  // When the cells on both sides of a (D - 1)-simplex enter, never() for the outside; the same
  // twice for a D-simplex, never() for what ends less than R^D.
  [[nodiscard]] std::array<std::uint32_t, 2> entering_beside(SimplexId simplex) const {
    if (triangulation_.affine_dimension() < D) return {never(), never()};
    if (simplex.row() >= table_.first(D)) return {enters(simplex), enters(simplex)};
    const std::uint32_t owner = table_.facet_owners()[simplex.row() - table_.first(D - 1)];
    const auto enters_of_cell = [&](std::uint32_t cell) {
      return indices_.enters[table_.first(D) + cell];
    };
    const std::uint32_t beyond =
        triangulation_.template cells<D>()[owner / 4].neighbours[owner % 4];
    return {enters_of_cell(owner / 4), beyond == kOutside ? never() : enters_of_cell(beyond / 4)};
  }

  RegularTriangulation<D> triangulation_;
  SimplexTable<D> table_;
  std::vector<std::uint64_t> is_attached_;  // bit per simplex
  RawVector<double> spectrum_;              // [index - 1]
  bool is_coarse_ = false;
  CriticalIndices indices_;  // by simplex
};

extern template class Filtration<2>;  // defined in filtration.cpp
extern template class Filtration<3>;

}  // namespace orthoball
