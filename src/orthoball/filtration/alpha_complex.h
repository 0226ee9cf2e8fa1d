// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/filtration/interval_tree.h"
#include "orthoball/ids.h"

namespace orthoball {

/// The complex of one shape: K_index of a filtration, a view of two words; or another complex of
/// the same triangulation that takes its place, such as `regularized` and `edited_shape` make, with
/// a byte a simplex.
///
/// Refers to the filtration, which must outlive it. Exact. Immutable; any number of threads may
/// read it.
template <int D>
class AlphaComplex {
 public:
  /// K_index.
  /// @throws InputError for an index beyond the spectrum's size; index 0 is the empty complex.
  AlphaComplex(const Filtration<D>& filtration, std::uint32_t index);
  /// Some simplices and all their faces, in the place of K_index. Roles are what they are to each
  /// other: singular is a face of nothing else, interior what has cells all around.
  /// @throws InputError as above.
  AlphaComplex(const Filtration<D>& filtration, std::uint32_t index,
               std::span<const SimplexId> simplices);

  [[nodiscard]] const Filtration<D>& filtration() const { return *filtration_; }
  /// 0..s
  [[nodiscard]] std::uint32_t index() const { return index_; }

  [[nodiscard]] bool contains(SimplexId simplex) const {
    return roles_.empty() ? filtration_->enters(simplex) <= index_
                          : role(simplex) != Role::exterior;
  }
  [[nodiscard]] Role role(SimplexId simplex) const {
    return roles_.empty() ? filtration_->role(simplex, index_)
                          : static_cast<Role>(roles_[simplex.row()]);
  }
  /// The simplices of one dimension in one role, ascending. O(n); see BoundaryIndex for many
  /// indices.
  [[nodiscard]] std::vector<SimplexId> simplices(int dimension, Role role) const;
  /// Those that are faces of nothing else in it: cells and singular simplices, ascending.
  [[nodiscard]] std::vector<SimplexId> maximal_simplices() const;

 private:
  const Filtration<D>* filtration_;
  std::uint32_t index_;
  std::vector<std::uint8_t> roles_;  // [simplex]; empty for K_index
};

/// The cells of a complex and their faces: without singular simplices. O(n).
template <int D>
[[nodiscard]] AlphaComplex<D> regularized(const AlphaComplex<D>& complex);

/// The boundary of every alpha complex of a filtration, to be asked for at any index.
///
/// The boundary at an index: facets ((D - 1)-simplices) in [enters, interior), singular or regular,
/// and singular simplices of lower dimension, in [enters, regular). Exact. Refers to nothing once
/// built; immutable; any number of threads may read it.
///
/// One interval tree a dimension: up to 30 bytes a simplex below dimension D.
/// @cite edelsbrunner_1983
template <int D>
class BoundaryIndex {
 public:
  explicit BoundaryIndex(const Filtration<D>& filtration);

  /// The facets on the boundary of K_index, ascending. O(log n + k log k) for k of them.
  [[nodiscard]] std::vector<SimplexId> facets(std::uint32_t index) const {
    return simplices(D - 1, index);
  }
  /// The singular simplices of a dimension below D - 1 in K_index, ascending. O(log n + k log k).
  [[nodiscard]] std::vector<SimplexId> singular(int dimension, std::uint32_t index) const {
    return simplices(dimension, index);
  }

 private:
  [[nodiscard]] std::vector<SimplexId> simplices(int dimension, std::uint32_t index) const;

  std::array<std::uint32_t, std::size_t{D}> first_{};  // [dimension]: its first simplex
  std::array<IntervalTree, std::size_t{D}> trees_;     // [dimension]
};

extern template class AlphaComplex<2>;  // defined in alpha_complex.cpp
extern template class AlphaComplex<3>;
extern template class BoundaryIndex<2>;
extern template class BoundaryIndex<3>;
extern template AlphaComplex<2> regularized(const AlphaComplex<2>&);
extern template AlphaComplex<3> regularized(const AlphaComplex<3>&);

}  // namespace orthoball
