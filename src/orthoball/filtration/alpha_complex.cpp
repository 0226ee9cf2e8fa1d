// SPDX-License-Identifier: MIT
#include "orthoball/filtration/alpha_complex.h"

#include <algorithm>
#include <string>

#include "orthoball/error.h"

namespace orthoball {
namespace {

// Of what is marked as interior, and all faces of it: what they are to each other. From cells down:
// an interior simplex without a coface in the complex is singular, one with a coface that is not
// interior or not in the complex is regular.
template <int D>
void find_roles(const Filtration<D>& filtration, std::vector<std::uint8_t>& roles) {
  constexpr auto kExterior = static_cast<std::uint8_t>(Role::exterior);
  constexpr auto kInterior = static_cast<std::uint8_t>(Role::interior);
  const bool has_cells = filtration.triangulation().affine_dimension() == D;
  std::vector<std::uint8_t> cofaces(roles.size(), 0);  // bits: one in it; one that is not interior
  for (auto row = static_cast<std::uint32_t>(roles.size()); row-- > 0;) {
    const SimplexId simplex(row);
    const int dimension = filtration.dimension(simplex);
    if ((cofaces[row] & 1U) != 0) roles[row] = kInterior;
    if (roles[row] != kExterior && dimension < D) {
      const bool is_open =
          has_cells && dimension == D - 1 && filtration.cells_beside(simplex).size() < 2;
      const bool is_inside = (cofaces[row] & 2U) == 0 && !is_open;
      const Role role = (cofaces[row] & 1U) == 0 ? Role::singular
                        : is_inside              ? Role::interior
                                                 : Role::regular;
      roles[row] = static_cast<std::uint8_t>(role);
    }
    const unsigned bits = roles[row] == kExterior ? 2 : roles[row] == kInterior ? 1 : 3;
    for (const SimplexId facet : filtration.facets(simplex)) {
      cofaces[facet.row()] = static_cast<std::uint8_t>(cofaces[facet.row()] | bits);
    }
  }
}

}  // namespace

template <int D>
AlphaComplex<D>::AlphaComplex(const Filtration<D>& filtration, std::uint32_t index)
    : filtration_(&filtration), index_(index) {
  if (index > filtration.spectrum_size()) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "index " + std::to_string(index) + " is beyond the spectrum; it has " +
                         std::to_string(filtration.spectrum_size()) + " entries");
  }
}

template <int D>
AlphaComplex<D>::AlphaComplex(const Filtration<D>& filtration, std::uint32_t index,
                              std::span<const SimplexId> simplices)
    : AlphaComplex(filtration, index) {
  roles_.assign(filtration.size(), static_cast<std::uint8_t>(Role::exterior));
  for (const SimplexId simplex : simplices) {
    roles_[simplex.row()] = static_cast<std::uint8_t>(Role::interior);
  }
  find_roles(filtration, roles_);
}

template <int D>
std::vector<SimplexId> AlphaComplex<D>::simplices(int dimension, Role role) const {
  const std::uint32_t first = filtration_->table().first(dimension);
  const auto count = static_cast<std::uint32_t>(filtration_->count(dimension));
  std::vector<SimplexId> result;
  for (std::uint32_t simplex = first; simplex < first + count; ++simplex) {
    if (this->role(SimplexId(simplex)) == role) result.emplace_back(simplex);
  }
  return result;
}

template <int D>
std::vector<SimplexId> AlphaComplex<D>::maximal_simplices() const {
  std::vector<SimplexId> result;
  const std::uint32_t first_cell = filtration_->table().first(D);
  for (std::uint32_t simplex = 0; simplex < filtration_->size(); ++simplex) {
    const Role role = this->role(SimplexId(simplex));
    if (role == Role::singular || (simplex >= first_cell && role == Role::interior)) {
      result.emplace_back(simplex);
    }
  }
  return result;
}

template <int D>
AlphaComplex<D> regularized(const AlphaComplex<D>& complex) {
  return {complex.filtration(), complex.index(), complex.simplices(D, Role::interior)};
}

template <int D>
BoundaryIndex<D>::BoundaryIndex(const Filtration<D>& filtration) {
  for (int dimension = 0; dimension < D; ++dimension) {
    const auto at = static_cast<std::size_t>(dimension);
    first_[at] = filtration.table().first(dimension);
    std::vector<IndexInterval> intervals(filtration.count(dimension));
    for (std::uint32_t i = 0; i < intervals.size(); ++i) {
      const SimplexId simplex(first_[at] + i);
      intervals[i] = {filtration.enters(simplex), dimension == D - 1 ? filtration.interior(simplex)
                                                                     : filtration.regular(simplex)};
    }
    trees_[at] = IntervalTree(intervals);
  }
}

template <int D>
std::vector<SimplexId> BoundaryIndex<D>::simplices(int dimension, std::uint32_t index) const {
  const auto at = static_cast<std::size_t>(dimension);
  std::vector<SimplexId> result;
  trees_[at].for_each_containing(index,
                                 [&](std::uint32_t row) { result.emplace_back(first_[at] + row); });
  std::sort(result.begin(), result.end());
  return result;
}

template class AlphaComplex<2>;
template class AlphaComplex<3>;
template class BoundaryIndex<2>;
template class BoundaryIndex<3>;
template AlphaComplex<2> regularized(const AlphaComplex<2>&);
template AlphaComplex<3> regularized(const AlphaComplex<3>&);

}  // namespace orthoball
