// SPDX-License-Identifier: MIT
//
// When every simplex enters, becomes regular and becomes interior, as ranks.
//
// The unattached simplices have ranks by their own values (value_ranks.h, ranks_among.h). These go
// down the dimensions: an attached simplex enters with the first of its cofaces; the first proper
// coface makes a simplex regular, the last cell around it makes it interior.
//
// Edelsbrunner, Muecke. Three-dimensional alpha shapes. ACM Transactions on Graphics 13 (1994).
#include "orthoball/filtration/critical_indices.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/exact/processor.h"
#include "orthoball/exact/unrolled.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/edge_ring.h"

#ifdef ORTHOBALL_WIDE_CODE
#include <immintrin.h>
#endif

namespace orthoball {
namespace {

// What a face may have learned from a cell or an edge that belongs to an earlier or later part.
struct Late {
  std::uint32_t face;
  RoleIndices roles;
};

// Cells with the facets, edges and vertices that belong to them: of edges and facets those that the
// cells own, of vertices those from the first corner of the first cell up to that of the next part.
struct Part {
  std::uint32_t begin;  // of its cells
  std::uint32_t end;
  std::uint32_t next_facet;
  std::uint32_t first_edge;
  std::uint32_t end_edge;
  std::uint32_t end_vertex;
  std::uint32_t spare;     // the element that facets of other cells are written to
  std::vector<Late> late;  // for faces of other parts
};

// Elements to spare lie so far from each other and from all others that no two parts write to the
// same lines of the cache.
constexpr std::size_t kApart = 32;

// One pass over the cells, which takes facets in the order of their numbers, then one over the
// edges in space, both part by part. A >= 1.
//
// Whether a cell owns a facet and whether a simplex is attached is as good as random: nothing here
// branches on it.
template <int D, int A>
class HandDown {
 public:
  HandDown(std::span<const CellRecord<A>> cells, const SimplexTable<D>& table,
           const typename SimplexTable<D>::EdgesOfCells& edges_of_cells,
           std::span<const std::uint64_t> is_attached, std::uint32_t never, CriticalIndices& result)
      : cells_(cells),
        table_(table),
        edges_of_cells_(edges_of_cells),
        is_attached_(is_attached),
        result_(result),
        never_(never) {}

  void run(std::size_t parts, Threads threads) {
    result_.roles.resize(table_.first(kFillsSpace ? A - 1 : A));
    const RoleIndices unknown{.regular = never_, .interior = kFillsSpace ? 0 : never_};
    parallel_parts(threads, result_.roles.size(), parts,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     std::fill(&result_.roles[0] + begin, &result_.roles[0] + end, unknown);
                   });
    cut(parts);
    parallel_for(threads, parts, [&](std::size_t i) { pass_cells(parts_[i]); });
    catch_up();
    if constexpr (A == 3) {
      parallel_for(threads, parts, [&](std::size_t i) { pass_edges(parts_[i]); });
      catch_up();
    }
    for (std::uint32_t vertex = 0; vertex < table_.count(0); ++vertex) enter_if_attached(vertex);
  }

 private:
  static constexpr bool kFillsSpace = A == D;
  // [corner]: when the facet opposite enters; never where another cell owns it.
  using FacetIndices = std::array<std::uint32_t, std::size_t{A} + 1>;

  void cut(std::size_t parts) {
    for (std::size_t i = 0; i < parts; ++i) {
      const auto begin = static_cast<std::uint32_t>(cells_.size() * i / parts);
      const auto end = static_cast<std::uint32_t>(cells_.size() * (i + 1) / parts);
      const auto spare = static_cast<std::uint32_t>(table_.size() + (i + 1) * kApart);
      Part part{begin, end, table_.first(A - 1), 0, 0, never_vertex(end), spare, {}};
      if constexpr (A > 1) part.next_facet += table_.facets_owned_before(begin);
      if constexpr (A == 3) {
        part.first_edge = table_.first(1) + table_.edges_owned_before(begin);
        part.end_edge = table_.first(1) + table_.edges_owned_before(end);
      }
      parts_.push_back(std::move(part));
    }
  }
  [[nodiscard]] std::uint32_t never_vertex(std::uint32_t cell) const {
    return cell < cells_.size() ? cells_[cell].corners[0] : static_cast<std::uint32_t>(-1);
  }
  void catch_up() {
    for (Part& part : parts_) {
      for (const Late& late : part.late) learn(late.face, late.roles);
      part.late.clear();
    }
  }

  [[nodiscard]] std::uint32_t enters_of_cell(std::uint32_t cell) const {
    return result_.enters[table_.first(A) + cell];
  }
  void learn(std::uint32_t face, RoleIndices roles) {
    RoleIndices& known = result_.roles[face];
    known.regular = std::min(known.regular, roles.regular);
    known.interior = std::max(known.interior, roles.interior);
  }
  void learn_of_vertex(Part& part, std::uint32_t vertex, RoleIndices roles) {
    if (vertex >= part.end_vertex) return part.late.push_back({vertex, roles});
    learn(vertex, roles);
  }
  void learn_of_edge(Part& part, std::uint32_t edge, RoleIndices roles) {
    if (edge < part.first_edge) return part.late.push_back({edge, roles});
    learn(edge, roles);
  }
  // All ones or 0.
  [[nodiscard]] std::uint32_t mask_of_attached(std::uint32_t simplex) const {
    return 0U - static_cast<std::uint32_t>(is_attached_[simplex / 64] >> simplex % 64 & 1U);
  }
  void enter_if_attached(std::uint32_t simplex) {
    const std::uint32_t attached = mask_of_attached(simplex);
    std::uint32_t& enters = result_.enters[simplex];
    enters = (result_.roles[simplex].regular & attached) | (enters & ~attached);
  }

  void pass_cells(Part& part) {
#ifdef ORTHOBALL_WIDE_CODE
    if constexpr (A == 3) {
      if (has_avx2()) return pass_cells_in_lanes(part);
    }
#endif
    for (std::uint32_t cell = part.begin; cell < part.end; ++cell) {
      const FacetIndices facets = pass_facets(part, cell);
      pass_cell(part, cell, facets);
    }
  }

#ifdef ORTHOBALL_WIDE_CODE
  // The same where the processor has the vectors: all six edges of a cell at once.
  ORTHOBALL_AVX2 void pass_cells_in_lanes(Part& part) {
    for (std::uint32_t cell = part.begin; cell < part.end; ++cell) {
      fetch_beyond(cell + kAhead);
      const FacetIndices facets = pass_facets(part, cell);
      const std::uint32_t index = enters_of_cell(cell);
      const auto& edges = edges_of_cells_[cell];
      const std::uint32_t first = table_.first(1);
      const std::uint32_t least =
          std::min({edges[0], edges[1], edges[2], edges[3], edges[4], edges[5]});
      const auto& corners = cells_[cell].corners;
      if (first + least < part.first_edge ||
          std::max({corners[1], corners[2], corners[3]}) >= part.end_vertex) {
        pass_cell(part, cell, facets);
        continue;
      }
      for (const std::uint32_t vertex : corners) {
        std::uint32_t& interior = result_.roles[vertex].interior;
        interior = std::max(interior, index);
      }
      // [slot]: the first of the two facets at each edge, the second.
      const __m256i of_facets = _mm256_castsi128_si256(
          _mm_setr_epi32(static_cast<int>(facets[0]), static_cast<int>(facets[1]),
                         static_cast<int>(facets[2]), static_cast<int>(facets[3])));
      const __m256i regular = _mm256_min_epu32(
          _mm256_permutevar8x32_epi32(of_facets, _mm256_setr_epi32(2, 1, 1, 0, 0, 0, 0, 0)),
          _mm256_permutevar8x32_epi32(of_facets, _mm256_setr_epi32(3, 3, 2, 3, 2, 1, 0, 0)));
      const __m256i interior = _mm256_set1_epi32(static_cast<int>(index));
      const __m256i slots_0145 = _mm256_unpacklo_epi32(regular, interior);
      const __m256i slots_23 = _mm256_unpackhi_epi32(regular, interior);
      RoleIndices* const roles = result_.roles.data() + first;
      learn_of_two(roles[edges[0]], roles[edges[1]], _mm256_castsi256_si128(slots_0145));
      learn_of_two(roles[edges[2]], roles[edges[3]], _mm256_castsi256_si128(slots_23));
      learn_of_two(roles[edges[4]], roles[edges[5]], _mm256_extracti128_si256(slots_0145, 1));
    }
  }
  static constexpr std::uint32_t kAhead = 8;  // cells
  // Asks for what a cell will read of its neighbours.
  [[gnu::always_inline]] inline void fetch_beyond(std::uint32_t cell) const {
    if (cell >= cells_.size()) return;
    for (const std::uint32_t beyond : cells_[cell].neighbours) {
      __builtin_prefetch(result_.enters.data() + table_.first(A) + beyond / 4);
    }
  }
  // learn() for two different faces.
  [[gnu::always_inline]] ORTHOBALL_AVX2 static inline void learn_of_two(RoleIndices& a,
                                                                        RoleIndices& b,
                                                                        __m128i roles) {
    const auto at = [](RoleIndices& face) { return reinterpret_cast<__m128i*>(&face); };
    const __m128i known = _mm_unpacklo_epi64(_mm_loadl_epi64(at(a)), _mm_loadl_epi64(at(b)));
    const __m128i first = _mm_min_epu32(known, roles);
    const __m128i last = _mm_max_epu32(known, roles);
    const __m128i both = _mm_blend_epi32(first, last, 0b1010);
    _mm_storel_epi64(at(a), both);
    _mm_storel_epi64(at(b), _mm_unpackhi_epi64(both, both));
  }
#endif

  // From cells to the facets that `cell` owns. For the others an element to spare stands in.
  [[gnu::always_inline]] inline FacetIndices pass_facets(Part& part, std::uint32_t cell) {
    FacetIndices result;
    const std::uint32_t own = enters_of_cell(cell);
    unrolled<std::size_t{A} + 1>([&](std::size_t corner) __attribute__((always_inline)) {
      const std::uint32_t beyond = cells_[cell].neighbours[corner];
      const bool is_hull = beyond == kOutside;
      const std::uint32_t owned = 0U - static_cast<std::uint32_t>(beyond / 4 > cell);
      const std::uint32_t next =
          A == 1 ? cells_[cell].corners[std::size_t{A} - corner] : part.next_facet;
      const std::uint32_t facet = (next & owned) | (part.spare & ~owned);
      const std::uint32_t regular = std::min(own, enters_of_cell(is_hull ? cell : beyond / 4));
      if (!kFillsSpace && owned != 0) result_.roles[facet].regular = regular;
      const std::uint32_t attached = mask_of_attached(next);
      std::uint32_t& place = result_.enters[facet];
      const std::uint32_t enters = (regular & attached) | (place & ~attached);
      place = enters;
      result[corner] = (enters & owned) | (never_ & ~owned);
      part.next_facet += owned & 1U;
      if (kFillsSpace && is_hull) end_at_hull(part, cell, static_cast<unsigned>(corner));
    });
    return result;
  }

  // From a cell and its facets to what is kept of their faces.
  void pass_cell(Part& part, std::uint32_t cell, const FacetIndices& facets) {
    const std::uint32_t index = kFillsSpace ? enters_of_cell(cell) : never_;
    for (unsigned corner = 0; corner <= A; ++corner) {
      const std::uint32_t vertex = cells_[cell].corners[corner];
      const std::uint32_t regular =
          A == 2 ? std::min(facets[(corner + 1) % 3], facets[(corner + 2) % 3]) : never_;
      if constexpr (kFillsSpace || A == 2) learn_of_vertex(part, vertex, {regular, index});
    }
    if constexpr (A == 3) {
      for (unsigned slot = 0; slot < 6; ++slot) {
        const std::uint32_t edge = table_.first(1) + edges_of_cells_[cell][slot];
        const auto [i, j] = kEdgeCorners[5 - slot];
        learn_of_edge(part, edge, {std::min(facets[i], facets[j]), index});
      }
    }
  }

  void end_at_hull(Part& part, std::uint32_t cell, unsigned corner) {
    for (unsigned other = 0; other <= A; ++other) {
      if (other == corner) continue;
      learn_of_vertex(part, cells_[cell].corners[other], {never_, never_});
      if constexpr (A == 3) {
        const std::uint32_t edge = edges_of_cells_[cell][5U - kEdgeSlot[corner][other]];
        learn_of_edge(part, table_.first(1) + edge, {never_, never_});
      }
    }
  }

  void pass_edges(Part& part) {
    for (std::uint32_t edge = part.first_edge; edge < part.end_edge; ++edge) {
      enter_if_attached(edge);
      const std::uint32_t owner = table_.edge_owners()[edge - table_.first(1)];
      for (const unsigned corner : kEdgeCorners[owner % 6]) {
        learn_of_vertex(part, cells_[owner / 6].corners[corner], {result_.enters[edge], 0});
      }
    }
  }

  std::span<const CellRecord<A>> cells_;
  const SimplexTable<D>& table_;
  const typename SimplexTable<D>::EdgesOfCells& edges_of_cells_;
  std::span<const std::uint64_t> is_attached_;
  CriticalIndices& result_;
  std::uint32_t never_;
  std::vector<Part> parts_;
};

}  // namespace

template <int D>
CriticalIndices critical_indices(const RegularTriangulation<D>& triangulation,
                                 const SimplexTable<D>& table,
                                 const typename SimplexTable<D>::EdgesOfCells& edges_of_cells,
                                 std::span<const std::uint64_t> is_attached, std::uint32_t ranks,
                                 const DealRanks& deal, Threads threads) {
  CriticalIndices result;
  result.enters.resize(table.size() + (std::size_t{threads.count()} + 1) * kApart);
  deal(std::span(result.enters).first(table.size()));
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      constexpr std::size_t kLeastPart = std::size_t{1} << 14U;
      const auto cells = triangulation.template cells<A>();
      const Threads used = threads.for_work(cells.size(), kLeastPart);
      HandDown<D, A>(cells, table, edges_of_cells, is_attached, ranks + 1, result)
          .run(used.count(), used);
    }
  });
  result.enters.resize(table.size());
  return result;
}

template CriticalIndices critical_indices<2>(const RegularTriangulation<2>&, const SimplexTable<2>&,
                                             const SimplexTable<2>::EdgesOfCells&,
                                             std::span<const std::uint64_t>, std::uint32_t,
                                             const DealRanks&, Threads);
template CriticalIndices critical_indices<3>(const RegularTriangulation<3>&, const SimplexTable<3>&,
                                             const SimplexTable<3>::EdgesOfCells&,
                                             std::span<const std::uint64_t>, std::uint32_t,
                                             const DealRanks&, Threads);

}  // namespace orthoball
