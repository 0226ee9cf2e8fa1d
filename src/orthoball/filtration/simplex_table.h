// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/ids.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// At most D + 1 elements, by value: the vertices or facets of one simplex.
template <class T, int D>
class FewOf {
 public:
  void push_back(T value) { values_[size_++] = value; }
  /// Before the elements that are greater: keeps ascending order.
  void insert(T value) {
    std::size_t place = size_++;
    for (; place > 0 && value < values_[place - 1]; --place) values_[place] = values_[place - 1];
    values_[place] = value;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return values_[i]; }
  [[nodiscard]] const T* begin() const { return values_.data(); }
  [[nodiscard]] const T* end() const { return values_.data() + size_; }
  [[nodiscard]] T* begin() { return values_.data(); }
  [[nodiscard]] T* end() { return values_.data() + size_; }

 private:
  std::array<T, static_cast<std::size_t>(D) + 1> values_{};
  std::size_t size_ = 0;
};

/// Bit i: the cell owns its facet opposite corner i, being the smaller of the two cells beside it.
template <int A>
[[nodiscard]] inline unsigned owned_facets(const CellRecord<A>& record, std::uint32_t cell) {
  unsigned mask = 0;
  for (unsigned corner = 0; corner <= A; ++corner) {
    const bool owns = record.neighbours[corner] == kOutside || record.neighbours[corner] / 4 > cell;
    mask |= static_cast<unsigned>(owns) << corner;
  }
  return mask;
}

/// Number of bits of a mask of at most four: without an instruction that older machines lack.
[[nodiscard]] constexpr std::uint32_t count_of_four(unsigned mask) {
  constexpr std::uint64_t kCounts = 0x4332322132212110U;  // [mask], four bits each
  return static_cast<std::uint32_t>(kCounts >> (4 * mask)) & 15U;
}

/// Every simplex of a regular triangulation, once, with its faces and cofaces one dimension apart.
///
/// A SimplexId counts the vertices first (vertex v is simplex v), then the edges, the triangles,
/// the tetrahedra; each dimension in the order of the cells that own them, so that neighbours in
/// space have near numbers. A facet is owned by the smaller of its two cells, an edge in space by
/// the smallest cell around it. For sites that span less than R^D the dimensions above are empty.
///
/// O(n) time for n simplices, no hashing; 22 bytes a tetrahedron. Does not own the triangulation:
/// its member functions take the one it was made from. Immutable; any number of threads may read.
template <int D>
class SimplexTable {
 public:
  /// [cell][slot]: number of the edge within its dimension; empty unless the cells are tetrahedra.
  using EdgesOfCells = std::vector<std::array<std::uint32_t, 6>>;

  SimplexTable() = default;
  /// @throws LimitError for 2^32 - 1 simplices or 2^32 / 6 tetrahedra or more.
  explicit SimplexTable(const RegularTriangulation<D>& triangulation);
  /// The same, and the edges of every tetrahedron as a by-product (24 bytes each).
  /// @throws LimitError likewise.
  SimplexTable(const RegularTriangulation<D>& triangulation, EdgesOfCells& edges_of_cells);

  /// Number of simplices of a dimension 0..D.
  [[nodiscard]] std::size_t count(int dimension) const {
    return first_[static_cast<std::size_t>(dimension) + 1] -
           first_[static_cast<std::size_t>(dimension)];
  }
  /// Number of simplices of all dimensions.
  [[nodiscard]] std::size_t size() const { return first_.back(); }
  /// The first simplex of a dimension.
  [[nodiscard]] std::uint32_t first(int dimension) const {
    return first_[static_cast<std::size_t>(dimension)];
  }
  /// 0..D. Undefined for an id that is none of size().
  [[nodiscard]] int dimension(SimplexId simplex) const {
    int dimension = 0;
    while (simplex.row() >= first_[static_cast<std::size_t>(dimension) + 1]) ++dimension;
    return dimension;
  }

  /// The vertices by number, ascending.
  [[nodiscard]] FewOf<VertexId, D> vertices(const RegularTriangulation<D>& triangulation,
                                            SimplexId simplex) const;
  /// The faces one dimension down, facet i without vertex i of vertices(); none for a vertex.
  /// The edges of a triangle in space are found by walking around each.
  [[nodiscard]] FewOf<SimplexId, D> facets(const RegularTriangulation<D>& triangulation,
                                           SimplexId simplex) const;
  /// The one or two cells beside a simplex one dimension below affine_dimension(), its owner
  /// first.
  [[nodiscard]] FewOf<SimplexId, D> cells_beside(const RegularTriangulation<D>& triangulation,
                                                 SimplexId facet) const;

  /// The facet of a cell opposite a corner, as its number within its dimension.
  template <int A>
  [[nodiscard]] std::uint32_t facet_of_cell(std::span<const CellRecord<A>> cells,
                                            std::uint32_t cell, unsigned corner) const {
    if constexpr (A == 1) return cells[cell].corners[1 - corner];
    const std::uint32_t beyond = cells[cell].neighbours[corner];
    if (beyond != kOutside && beyond / 4 < cell) {
      cell = beyond / 4;
      corner = beyond % 4;
    }
    const unsigned before = owned_facets(cells[cell], cell) & ((1U << corner) - 1U);
    return first_facet_[cell] + count_of_four(before);
  }
  /// [facet]: 4 * cell + corner, the owner of a facet and the corner opposite.
  [[nodiscard]] const std::vector<std::uint32_t>& facet_owners() const { return facet_owners_; }
  /// [edge]: 6 * cell + slot, the owner of an edge and its place in it; affine dimension 3 only.
  [[nodiscard]] const std::vector<std::uint32_t>& edge_owners() const { return edge_owners_; }

 private:
  template <int A>
  void add_facets(std::span<const CellRecord<A>> cells);
  void add_edges(std::span<const CellRecord<3>> cells, EdgesOfCells& edges_of_cells);
  [[nodiscard]] std::uint32_t edge_of_cell(std::span<const CellRecord<3>> cells, std::uint32_t cell,
                                           unsigned slot) const;
  [[nodiscard]] FewOf<SimplexId, D> facets_of_cell(const RegularTriangulation<D>& triangulation,
                                                   std::uint32_t cell) const;

  std::array<std::uint32_t, static_cast<std::size_t>(D) + 2> first_{};
  std::vector<std::uint32_t> first_facet_;   // [cell]: number of the first facet it owns
  std::vector<std::uint32_t> facet_owners_;  // [facet]
  std::vector<std::uint32_t> first_edge_;    // [cell]: number of the first edge it owns
  std::vector<std::uint8_t> owned_edges_;    // [cell]: bit per slot
  std::vector<std::uint32_t> edge_owners_;   // [edge]
};

extern template class SimplexTable<2>;  // defined in simplex_table.cpp
extern template class SimplexTable<3>;

}  // namespace orthoball
