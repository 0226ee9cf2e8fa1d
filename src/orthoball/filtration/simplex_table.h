// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/ranked_bits.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"
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

/// Every simplex of a regular triangulation, once, with its faces and cofaces one dimension apart.
///
/// A SimplexId counts the vertices first (vertex v is simplex v), then the edges, the triangles,
/// the tetrahedra; each dimension in the order of the cells that own them, so that neighbours in
/// space have near numbers. A facet is owned by the smaller of its two cells, an edge in space by
/// the smallest cell around it. For sites that span less than R^D the dimensions above are empty.
///
/// O(n) time for n simplices, no hashing; 15 bytes a tetrahedron. Does not own the triangulation:
/// its member functions take the one it was made from. Immutable; any number of threads may read.
template <int D>
class SimplexTable {
 public:
  /// [cell][slot]: number of the edge within its dimension; empty unless the cells are tetrahedra.
  using EdgesOfCells = RawVector<std::array<std::uint32_t, 6>>;

  SimplexTable() = default;
  /// @throws LimitError for 2^32 - 1 simplices or 2^32 / 6 tetrahedra or more.
  explicit SimplexTable(const RegularTriangulation<D>& triangulation);
  /// The same, and the edges of every tetrahedron as a by-product (24 bytes each).
  /// @throws LimitError likewise.
  SimplexTable(const RegularTriangulation<D>& triangulation, EdgesOfCells& edges_of_cells,
               Threads threads = {});

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
    return owned_facets_.rank(beyond / 4 < cell ? beyond : 4 * cell + corner);
  }
  /// How many facets are owned by cells before this one: the number of its first.
  [[nodiscard]] std::uint32_t facets_owned_before(std::uint32_t cell) const {
    return owned_facets_.rank(4 * cell);
  }
  /// The same of edges in space.
  [[nodiscard]] std::uint32_t edges_owned_before(std::uint32_t cell) const {
    return owned_edges_.rank(6 * cell);
  }
  /// [facet]: 4 * cell + corner, the owner of a facet and the corner opposite.
  [[nodiscard]] std::span<const std::uint32_t> facet_owners() const { return facet_owners_; }
  /// [edge]: 6 * cell + slot, the owner of an edge and its place in it; affine dimension 3 only.
  [[nodiscard]] std::span<const std::uint32_t> edge_owners() const { return edge_owners_; }

 private:
  template <int A>
  void add_facets(std::span<const CellRecord<A>> cells, Threads threads);
  void add_edges(std::span<const CellRecord<3>> cells, EdgesOfCells& edges_of_cells,
                 Threads threads);
  [[nodiscard]] std::uint32_t edge_of_cell(std::span<const CellRecord<3>> cells, std::uint32_t cell,
                                           unsigned slot) const;

  std::array<std::uint32_t, static_cast<std::size_t>(D) + 2> first_{};
  RankedBits owned_facets_;                // 4 * cell + corner opposite: the owners
  RawVector<std::uint32_t> facet_owners_;  // [facet]
  RankedBits owned_edges_;                 // 6 * cell + slot: the owners
  RawVector<std::uint32_t> edge_owners_;   // [edge]
};

extern template class SimplexTable<2>;  // defined in simplex_table.cpp
extern template class SimplexTable<3>;

}  // namespace orthoball
