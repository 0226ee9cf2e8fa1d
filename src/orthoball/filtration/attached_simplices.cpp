// SPDX-License-Identifier: MIT
//
// A simplex is attached exactly if one of the vertices that make its cofaces attaches it, so every
// cell is asked about all its faces by itself (attached_faces), and a simplex is attached if any
// cell around it says so.
#include "orthoball/filtration/attached_simplices.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "orthoball/exact/attached_faces.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/edge_ring.h"

namespace orthoball {
namespace {

template <int A>
using Cells = std::span<const CellRecord<A>>;

// [cell]: as attached_faces writes it.
template <int D, int A>
std::vector<std::uint16_t> faces_of_cells(const Sites<D>& sites, Cells<A> cells) {
  constexpr std::size_t kBlock = 256;
  std::array<CornerSites<std::size_t{A} + 1>, kBlock> corners;
  std::vector<std::uint16_t> faces(cells.size());
  for (std::size_t first = 0; first < cells.size(); first += kBlock) {
    const std::size_t size = std::min(kBlock, cells.size() - first);
    for (std::size_t i = 0; i < size; ++i) corners[i] = cells[first + i].corners;
    attached_faces<D, std::size_t{A} + 1>(sites, std::span(corners).first(size),
                                          std::span(faces).subspan(first, size));
  }
  return faces;
}

// Facets in the order of their numbers, that of the cells that own them.
template <int A>
void mark_facets(Cells<A> cells, std::span<const std::uint16_t> faces, std::size_t first,
                 std::vector<bool>& is_attached) {
  constexpr unsigned kAll = (2U << A) - 1;
  const auto says = [&](std::uint32_t cell, unsigned corner) {
    return (unsigned{faces[cell]} >> (kAll ^ 1U << corner) & 1U) != 0;
  };
  auto facet = is_attached.begin() + static_cast<std::ptrdiff_t>(first);
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    for (unsigned corner = 0; corner <= A; ++corner) {
      const std::uint32_t beyond = cells[cell].neighbours[corner];
      if (beyond / 4 < cell) continue;
      *facet++ = says(cell, corner) || (beyond != kOutside && says(beyond / 4, beyond % 4));
    }
  }
}

// Faces that may have many cells around them: `numbers(cell)[i]` is one in any order, `bits[i]` its
// corners.
template <std::size_t Size, class Numbers>
void mark_faces(std::span<const std::uint16_t> faces, const std::array<unsigned, Size>& bits,
                const Numbers& numbers, std::size_t first, std::size_t count,
                std::vector<bool>& is_attached) {
  std::vector<std::uint8_t> marks(count, 0);
  for (std::uint32_t cell = 0; cell < faces.size(); ++cell) {
    const std::array<std::uint32_t, Size>& of_cell = numbers(cell);
    const unsigned said = faces[cell];
    for (std::size_t i = 0; i < Size; ++i) {
      marks[of_cell[i]] |= static_cast<std::uint8_t>(said >> bits[i] & 1U);
    }
  }
  std::copy(marks.begin(), marks.end(), is_attached.begin() + static_cast<std::ptrdiff_t>(first));
}

template <std::size_t Corners>
constexpr std::array<unsigned, Corners> single_corners() {
  std::array<unsigned, Corners> bits{};
  for (unsigned corner = 0; corner < Corners; ++corner) bits[corner] = 1U << corner;
  return bits;
}

constexpr std::array<unsigned, 6> edge_corners() {
  std::array<unsigned, 6> bits{};
  for (std::size_t slot = 0; slot < 6; ++slot) {
    bits[slot] = 1U << kEdgeCorners[slot][0] | 1U << kEdgeCorners[slot][1];
  }
  return bits;
}

}  // namespace

template <int D>
std::vector<bool> attached_simplices(const RegularTriangulation<D>& triangulation,
                                     const SimplexTable<D>& table,
                                     const typename SimplexTable<D>::EdgesOfCells& edges_of_cells) {
  std::vector<bool> result(table.size(), false);
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      const auto cells = triangulation.template cells<A>();
      const auto faces = faces_of_cells<D, A>(triangulation.sites(), cells);
      if constexpr (A >= 2) mark_facets<A>(cells, faces, table.first(A - 1), result);
      if constexpr (A == 3) {
        mark_faces(
            faces,
            edge_corners(), [&](std::uint32_t cell) -> auto& { return edges_of_cells[cell]; },
            table.first(1), table.count(1), result);
      }
      if (!triangulation.sites().is_unweighted()) {
        mark_faces(
            faces, single_corners<std::size_t{A} + 1>(),
            [&](std::uint32_t cell) -> auto& { return cells[cell].corners; }, 0, table.count(0),
            result);
      }
    }
  });
  return result;
}

template std::vector<bool> attached_simplices<2>(const RegularTriangulation<2>&,
                                                 const SimplexTable<2>&,
                                                 const SimplexTable<2>::EdgesOfCells&);
template std::vector<bool> attached_simplices<3>(const RegularTriangulation<3>&,
                                                 const SimplexTable<3>&,
                                                 const SimplexTable<3>::EdgesOfCells&);

}  // namespace orthoball
