// SPDX-License-Identifier: MIT
//
// A simplex is attached exactly if one of the vertices that make its cofaces attaches it, so every
// cell is asked about all its faces by itself (attached_faces), and a simplex is attached if any
// cell around it says so. What a cell says is as good as random: nothing here branches on it.
#include "orthoball/filtration/attached_simplices.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <span>

#include "orthoball/exact/attached_faces.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/bit_run.h"
#include "orthoball/filtration/edge_ring.h"
#include "orthoball/raw_vector.h"

namespace orthoball {
namespace {

constexpr std::size_t kLeastPart = std::size_t{1} << 14U;  // cells of one part

template <int A>
using Cells = std::span<const CellRecord<A>>;
// [cell]: as attached_faces writes it.
using FacesOfCells = RawVector<std::uint16_t>;

template <int D, int A>
FacesOfCells faces_of_cells(const Sites<D>& sites, Cells<A> cells, Threads threads) {
  constexpr std::size_t kBlock = 256;
  FacesOfCells faces(cells.size());
  const std::size_t parts = cells.size() / kLeastPart + 1;
  parallel_parts(threads, cells.size(), parts,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   std::array<CornerSites<std::size_t{A} + 1>, kBlock> corners;
                   for (std::size_t first = begin; first < end; first += kBlock) {
                     const std::size_t size = std::min(kBlock, end - first);
                     for (std::size_t i = 0; i < size; ++i) corners[i] = cells[first + i].corners;
                     attached_faces<D, std::size_t{A} + 1>(sites, std::span(corners).first(size),
                                                           std::span(faces).subspan(first, size));
                   }
                 });
  return faces;
}

// Facets in the order of their numbers, that of the cells that own them.
template <int D, int A>
[[gnu::noinline]] void mark_facets(Cells<A> cells, const FacesOfCells& faces,
                                   const SimplexTable<D>& table, Threads threads,
                                   std::uint64_t* is_attached) {
  constexpr unsigned kAll = (2U << A) - 1;
  const auto says = [&](std::uint32_t cell, unsigned corner) {
    return unsigned{faces[cell]} >> (kAll ^ 1U << corner) & 1U;
  };
  const std::size_t parts = cells.size() / kLeastPart + 1;
  parallel_parts(
      threads, cells.size(), parts, [&](std::size_t, std::size_t begin, std::size_t end) {
        const auto first = static_cast<std::uint32_t>(begin);
        BitRun run(is_attached, table.first(A - 1) + table.facets_owned_before(first));
        for (std::uint32_t cell = first; cell < end; ++cell) {
          for (unsigned corner = 0; corner <= A; ++corner) {
            const std::uint32_t beyond = cells[cell].neighbours[corner];
            const bool is_hull = beyond == kOutside;
            const unsigned other = says(is_hull ? cell : beyond / 4, is_hull ? corner : beyond % 4);
            run.push_if(beyond / 4 > cell, (says(cell, corner) | other) != 0);
          }
        }
      });
}

// Faces that may have many cells around them: `numbers(cell)[i]` is one in any order, `bits[i]` its
// corners.
template <std::size_t Size, class Numbers>
[[gnu::noinline]] void mark_faces(const FacesOfCells& faces, const std::array<unsigned, Size>& bits,
                                  const Numbers& numbers, std::size_t first, std::size_t count,
                                  Threads threads, std::uint64_t* is_attached) {
  const std::size_t parts = faces.size() / kLeastPart + 1;
  // Before those of the faces one to spare for each part, in a line of the cache of its own.
  constexpr std::size_t kApart = 128;
  const std::size_t first_mark = parts * kApart;
  std::vector<std::uint8_t> marks(first_mark + count, 0);
  parallel_parts(
      threads, faces.size(), parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
        const std::size_t spare = part * kApart;
        for (std::size_t cell = begin; cell < end; ++cell) {
          const std::array<std::uint32_t, Size>& of_cell = numbers(cell);
          const unsigned said = faces[cell];
          for (std::size_t i = 0; i < Size; ++i) {
            const std::size_t is_said = std::size_t{0} - (said >> bits[i] & 1U);
            const std::size_t mark = ((first_mark + of_cell[i]) & is_said) | (spare & ~is_said);
            std::atomic_ref(marks[mark]).store(1, std::memory_order_relaxed);
          }
        }
      });
  parallel_parts(threads, count, parts, [&](std::size_t, std::size_t begin, std::size_t end) {
    BitRun run(is_attached, first + begin);
    for (std::size_t face = begin; face < end; ++face) run.push(marks[first_mark + face] != 0);
  });
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
std::vector<std::uint64_t> attached_simplices(
    const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
    const typename SimplexTable<D>::EdgesOfCells& edges_of_cells, Threads threads) {
  std::vector<std::uint64_t> result(table.size() / 64 + 1, 0);
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      const auto cells = triangulation.template cells<A>();
      const Threads used = threads.for_work(cells.size(), kLeastPart);
      const auto faces = faces_of_cells<D, A>(triangulation.sites(), cells, used);
      if constexpr (A >= 2) mark_facets<D, A>(cells, faces, table, used, result.data());
      if constexpr (A == 3) {
        mark_faces(
            faces, edge_corners(), [&](std::size_t cell) -> auto& { return edges_of_cells[cell]; },
            table.first(1), table.count(1), used, result.data());
      }
      if (!triangulation.sites().is_unweighted()) {
        mark_faces(
            faces, single_corners<std::size_t{A} + 1>(),
            [&](std::size_t cell) -> auto& { return cells[cell].corners; }, 0, table.count(0), used,
            result.data());
      }
    }
  });
  return result;
}

template std::vector<std::uint64_t> attached_simplices<2>(const RegularTriangulation<2>&,
                                                          const SimplexTable<2>&,
                                                          const SimplexTable<2>::EdgesOfCells&,
                                                          Threads);
template std::vector<std::uint64_t> attached_simplices<3>(const RegularTriangulation<3>&,
                                                          const SimplexTable<3>&,
                                                          const SimplexTable<3>::EdgesOfCells&,
                                                          Threads);

}  // namespace orthoball
