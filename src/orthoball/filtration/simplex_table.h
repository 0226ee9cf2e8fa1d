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
/// O(n) time for n simplices, no hashing. Does not own the triangulation.
template <int D>
class SimplexTable {
 public:
  SimplexTable() = default;
  /// @throws LimitError for 2^32 - 1 simplices or more.
  explicit SimplexTable(const RegularTriangulation<D>& triangulation);

  /// Number of simplices of a dimension 0..D; of all.
  [[nodiscard]] std::size_t count(int dimension) const {
    return first_[static_cast<std::size_t>(dimension) + 1] -
           first_[static_cast<std::size_t>(dimension)];
  }
  [[nodiscard]] std::size_t size() const { return first_.back(); }
  /// The first simplex of a dimension.
  [[nodiscard]] std::uint32_t first(int dimension) const {
    return first_[static_cast<std::size_t>(dimension)];
  }
  [[nodiscard]] int dimension(SimplexId simplex) const {
    int dimension = 0;
    while (simplex.row() >= first_[static_cast<std::size_t>(dimension) + 1]) ++dimension;
    return dimension;
  }

 private:
  std::array<std::uint32_t, static_cast<std::size_t>(D) + 2> first_{};
};

}  // namespace orthoball
