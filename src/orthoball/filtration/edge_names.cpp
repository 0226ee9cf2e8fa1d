// SPDX-License-Identifier: MIT
//
// Cells are taken in ascending order. A cell takes over the names of the edges of every facet that
// it shares with a smaller cell; an edge that it finds on none of these gets a new name. So a ring
// of cells around an edge has a name for each cell that is smaller than both its neighbours in the
// ring, the first from the smallest of all; where two names meet, at the latest in the ring's
// largest cell, they are united.
//
// No ring is walked: a step around an edge waits for the one before, while all that is read here is
// known beforehand. In lanes nothing is asked but whether two names meet: which neighbours are
// smaller and which edges are new is hard to foretell, so a neighbour that is not smaller is
// replaced by the cell itself, whose edges have no names yet.
#include "orthoball/filtration/edge_names.h"

#include "orthoball/exact/processor.h"
#include "orthoball/exact/unrolled.h"

#ifdef ORTHOBALL_WIDE_CODE
#include <immintrin.h>
#endif

namespace orthoball {
namespace edge_names_stages {
namespace {

constexpr std::uint32_t kNameless = 0xFFFFFFFFU;

}  // namespace

std::uint32_t name_edges_one_by_one(std::span<const CellRecord<3>> cells, CellRange range,
                                    std::array<std::uint32_t, 6>* of_cells, EdgeNames& names) {
  std::uint32_t next = range.first_name;
  for (std::uint32_t cell = range.begin; cell < range.end; ++cell) {
    const unsigned descends_here = descends(cells[cell]);
    std::array<std::uint32_t, 6> edges;
    edges.fill(kNameless);
    for (unsigned corner = 0; corner < 4; ++corner) {
      const std::uint32_t beyond = cells[cell].neighbours[corner];
      if (beyond / 4 >= cell || beyond / 4 < range.begin) continue;  // kOutside, too
      const auto& others = of_cells[beyond / 4];
      const auto& here = kFacetSlots[ascending_corner(corner, descends_here)];
      const auto& there = kFacetSlots[ascending_corner(beyond % 4, descends(cells[beyond / 4]))];
      unrolled<3>([&](std::size_t i) {
        const std::uint32_t mine = edges[here[i]];
        const std::uint32_t other = others[there[i]];
        if (mine != other && mine != kNameless) names.unite(mine, other);
        edges[here[i]] = std::min(mine, other);
      });
    }
    for (const unsigned slot : kAscendingSlot[descends_here]) {
      if (edges[slot] != kNameless) continue;
      names[next] = next;
      edges[slot] = next++;
    }
    of_cells[cell] = edges;
  }
  return next;
}

#ifdef ORTHOBALL_WIDE_CODE

namespace {

using Lanes = std::array<std::uint32_t, 8>;

// [4 * corner here + corner there]: for every slot here of the facet opposite the first corner its
// slot there, opposite the second; else 7, a lane without a name.
constexpr std::array<Lanes, 16> kSlotThere = [] {
  std::array<Lanes, 16> slots{};
  for (std::size_t here = 0; here < 4; ++here) {
    for (std::size_t there = 0; there < 4; ++there) {
      Lanes& lanes = slots[4 * here + there];
      lanes.fill(7);
      for (std::size_t i = 0; i < 3; ++i) lanes[kFacetSlots[here][i]] = kFacetSlots[there][i];
    }
  }
  return slots;
}();

// What the lanes of nameless edges add to the next name, and how many there are.
struct NewNames {
  std::array<std::uint8_t, 8> ahead;
  std::uint32_t count;
};
// [descends][set of nameless slots]
constexpr std::array<std::array<NewNames, 64>, 2> kNewNames = [] {
  std::array<std::array<NewNames, 64>, 2> all{};
  for (std::size_t descends = 0; descends < 2; ++descends) {
    for (std::uint32_t nameless = 0; nameless < 64; ++nameless) {
      NewNames& names = all[descends][nameless];
      for (const unsigned slot : kAscendingSlot[descends]) {
        names.ahead[slot] = static_cast<std::uint8_t>(names.count);
        names.count += nameless >> slot & 1U;
      }
    }
  }
  return all;
}();

[[gnu::always_inline]] ORTHOBALL_AVX2 inline __m256i loaded(const std::uint32_t* numbers) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers));
}
[[gnu::always_inline]] ORTHOBALL_AVX2 inline void store(std::uint32_t* numbers, __m256i lanes) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(numbers), lanes);
}
// The six of a cell, and two lanes of ones.
[[gnu::always_inline]] ORTHOBALL_AVX2 inline __m256i loaded_names(
    const std::array<std::uint32_t, 6>& names) {
  const auto* const numbers = reinterpret_cast<const __m128i*>(names.data());
  const __m256i six = _mm256_inserti128_si256(_mm256_castsi128_si256(_mm_loadu_si128(numbers)),
                                              _mm_loadl_epi64(numbers + 1), 1);
  return _mm256_or_si256(six, _mm256_setr_epi32(0, 0, 0, 0, 0, 0, -1, -1));
}
[[gnu::always_inline]] ORTHOBALL_AVX2 inline void store_names(std::array<std::uint32_t, 6>& names,
                                                              __m256i lanes) {
  auto* const numbers = reinterpret_cast<__m128i*>(names.data());
  _mm_storeu_si128(numbers, _mm256_castsi256_si128(lanes));
  _mm_storel_epi64(numbers + 1, _mm256_extracti128_si256(lanes, 1));
}
// The set of lanes that are all ones.
[[gnu::always_inline]] ORTHOBALL_AVX2 inline std::uint32_t set_of(__m256i lanes) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(lanes)));
}

// The least and the greatest of the names that each edge of a cell has from smaller ones.
struct KnownNames {
  __m256i least;     // all ones where there is none
  __m256i greatest;  // one more than that; 0 where there is none
};

[[gnu::always_inline]] ORTHOBALL_AVX2 inline KnownNames known_names(
    std::span<const CellRecord<3>> cells, std::uint32_t first, std::uint32_t cell,
    const std::array<std::uint32_t, 6>* of_cells) {
  const __m256i ones = _mm256_set1_epi32(-1);
  const unsigned descends_here = descends(cells[cell]);
  KnownNames known{ones, _mm256_setzero_si256()};
  for (unsigned corner = 0; corner < 4; ++corner) {
    const std::uint32_t beyond = cells[cell].neighbours[corner];
    const bool is_smaller = beyond / 4 - first < cell - first;  // kOutside is not, nor others
    std::uint32_t other = is_smaller ? beyond / 4 : cell;
    __asm__("" : "+r"(other));  // else the compiler asks which it is
    const std::size_t here = ascending_corner(corner, descends_here);
    const std::size_t there = ascending_corner(beyond % 4, descends(cells[other]));
    const __m256i names = _mm256_permutevar8x32_epi32(loaded_names(of_cells[other]),
                                                      loaded(kSlotThere[4 * here + there].data()));
    known.least = _mm256_min_epu32(known.least, names);
    known.greatest = _mm256_max_epu32(known.greatest, _mm256_sub_epi32(names, ones));
  }
  return known;
}

}  // namespace

ORTHOBALL_AVX2 std::uint32_t name_edges_in_lanes(std::span<const CellRecord<3>> cells,
                                                 CellRange range,
                                                 std::array<std::uint32_t, 6>* of_cells,
                                                 EdgeNames& names) {
  const __m256i ones = _mm256_set1_epi32(-1);
  const __m256i ascending = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  std::uint32_t next = range.first_name;
  for (std::uint32_t cell = range.begin; cell < range.end; ++cell) {
    store_names(of_cells[cell], ones);
    const KnownNames known = known_names(cells, range.begin, cell, of_cells);
    const __m256i greatest = _mm256_add_epi32(known.greatest, ones);
    const __m256i nameless = _mm256_cmpeq_epi32(known.least, ones);
    const NewNames& fresh = kNewNames[descends(cells[cell])][set_of(nameless) & 63U];
    const __m256i from = _mm256_set1_epi32(static_cast<int>(next));
    const __m256i ahead =
        _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(fresh.ahead.data())));
    store_names(of_cells[cell],
                _mm256_blendv_epi8(known.least, _mm256_add_epi32(from, ahead), nameless));
    store(names.parents() + next, _mm256_add_epi32(from, ascending));
    next += fresh.count;

    std::uint32_t meet = ~set_of(_mm256_cmpeq_epi32(known.least, greatest)) & 0xFFU;
    if (meet == 0) continue;
    Lanes others;
    store(others.data(), greatest);
    for (; meet != 0; meet &= meet - 1) {
      const auto slot = static_cast<std::size_t>(__builtin_ctz(meet));
      names.unite(of_cells[cell][slot], others[slot]);
    }
  }
  return next;
}

#else

std::uint32_t name_edges_in_lanes(std::span<const CellRecord<3>> cells, CellRange range,
                                  std::array<std::uint32_t, 6>* of_cells, EdgeNames& names) {
  return name_edges_one_by_one(cells, range, of_cells, names);
}

#endif

}  // namespace edge_names_stages

std::uint32_t name_edges(std::span<const CellRecord<3>> cells, CellRange range,
                         std::array<std::uint32_t, 6>* of_cells, EdgeNames& names) {
  using namespace edge_names_stages;
  return has_avx2() ? name_edges_in_lanes(cells, range, of_cells, names)
                    : name_edges_one_by_one(cells, range, of_cells, names);
}

}  // namespace orthoball
