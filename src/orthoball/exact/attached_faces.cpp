// SPDX-License-Identifier: MIT
//
// All faces of a cell at once: its corners are fetched once for up to eleven simplices, whose signs
// in doubles are expressions without branches, taken for a block of cells in vector instructions.
// The few cells of which these leave anything open are taken again, simplex by simplex.
#include "orthoball/exact/attached_faces.h"

#include <algorithm>
#include <bit>
#include <type_traits>

#include "orthoball/exact/certified_label.h"
#include "orthoball/exact/orthocentre_signs.h"
#include "orthoball/exact/processor.h"
#include "orthoball/exact/unrolled.h"

namespace orthoball {
namespace {

// The corners of a face, ascending.
template <unsigned Face>
constexpr auto kCornersOf = [] {
  std::array<std::size_t, std::size_t{std::popcount(Face)}> corners{};
  std::size_t size = 0;
  for (std::size_t corner = 0; Face >> corner != 0; ++corner) {
    if ((Face >> corner & 1U) != 0) corners[size++] = corner;
  }
  return corners;
}();

// Calls `visit(constant)` for every face of two corners or more, the cell itself included.
template <std::size_t Corners, class Visit>
[[gnu::always_inline]] inline void for_each_face(const Visit& visit) {
  [&]<unsigned... Face>(std::integer_sequence<unsigned, Face...>) __attribute__((always_inline)) {
    const auto visit_face = [&]<unsigned F>() __attribute__((always_inline)) {
      if constexpr (std::popcount(F) >= 2) visit(std::integral_constant<unsigned, F>());
    };
    (visit_face.template operator()<Face>(), ...);
  }
  (std::make_integer_sequence<unsigned, 1U << Corners>());
}

// The facets of a face that lie on the far side, given the corners opposite them.
template <unsigned Face>
[[gnu::always_inline]] inline std::int64_t facets_beyond(std::int64_t beyond) {
  constexpr auto kCorners = kCornersOf<Face>;
  std::int64_t faces = 0;
  unrolled<kCorners.size()>([&](std::size_t i) __attribute__((always_inline)) {
    faces |= (beyond >> i & 1) << (Face & ~(1U << kCorners[i]));
  });
  return faces;
}

// Bit 0, which stands for no face, where doubles cannot tell.
template <int D, std::size_t Corners>
[[gnu::always_inline]] inline std::int64_t faces_of(const CornerBlock<D, Corners>& block,
                                                    std::size_t i, SignTolerance tolerance) {
  std::int64_t faces = 0;
  double certainty = 1.0;
  for_each_face<Corners>([&](auto face) __attribute__((always_inline)) {
    constexpr auto kCorners = kCornersOf<decltype(face)::value>;
    std::array<std::array<double, std::size_t{D}>, kCorners.size()> x;
    std::array<double, kCorners.size()> weights;
    unrolled<kCorners.size()>([&](std::size_t corner) __attribute__((always_inline)) {
      unrolled<std::size_t{D}>([&](std::size_t axis) __attribute__((always_inline)) {
        x[corner][axis] = block.x[kCorners[corner]][axis][i];
      });
      weights[corner] = block.weight[kCorners[corner]][i];
    });
    const OrthocentreSigns signs = orthocentre_signs<D, kCorners.size()>(x, weights, tolerance);
    faces |= facets_beyond<decltype(face)::value>(signs.beyond);
    certainty = std::min(certainty, signs.certainty);
  });
  return faces | (certainty > 0.0 ? 0 : 1);
}

template <int D, std::size_t Corners>
[[gnu::always_inline]] inline void faces_of_block(const CornerBlock<D, Corners>& block,
                                                  SignTolerance tolerance, std::int64_t* faces) {
  for (std::size_t i = 0; i < CornerBlock<D, Corners>::kSize; ++i) {
    faces[i] = faces_of(block, i, tolerance);
  }
}

template <int D, std::size_t Corners>
void faces_anywhere(const CornerBlock<D, Corners>& block, SignTolerance tolerance,
                    std::int64_t* faces) {
  faces_of_block(block, tolerance, faces);
}

template <int D, std::size_t Corners>
ORTHOBALL_AVX2 void faces_in_fours(const CornerBlock<D, Corners>& block, SignTolerance tolerance,
                                   std::int64_t* faces) {
  faces_of_block(block, tolerance, faces);
}

template <int D, std::size_t Corners>
ORTHOBALL_AVX512 void faces_in_eights(const CornerBlock<D, Corners>& block, SignTolerance tolerance,
                                      std::int64_t* faces) {
  faces_of_block(block, tolerance, faces);
}

template <int D, std::size_t Corners>
void faces_here(const CornerBlock<D, Corners>& block, SignTolerance tolerance,
                std::int64_t* faces) {
  if (has_avx512()) return faces_in_eights(block, tolerance, faces);
  if (has_avx2()) return faces_in_fours(block, tolerance, faces);
  faces_anywhere(block, tolerance, faces);
}

// The same by filter and integers, simplex by simplex.
template <int D, std::size_t Corners>
std::uint16_t faces_of_one(const Sites<D>& sites, const CornerSites<Corners>& cell) {
  std::int64_t faces = 0;
  for_each_face<Corners>([&](auto face) {
    constexpr auto kCorners = kCornersOf<decltype(face)::value>;
    CornerSites<kCorners.size()> simplex;
    for (std::size_t i = 0; i < kCorners.size(); ++i) simplex[i] = cell[kCorners[i]];
    faces |=
        facets_beyond<decltype(face)::value>(attached_facets<D, kCorners.size()>(sites, simplex));
  });
  return static_cast<std::uint16_t>(faces);
}

}  // namespace

template <int D, std::size_t Corners>
void attached_faces(const Sites<D>& sites, std::span<const CornerSites<Corners>> cells,
                    std::span<std::uint16_t> faces) {
  using Block = CornerBlock<D, Corners>;
  const SignTolerance tolerance = sign_tolerance(sites);
  Block block{};
  std::array<std::int64_t, Block::kSize> found;
  for (std::size_t first = 0; first < cells.size(); first += Block::kSize) {
    const std::size_t size = std::min(Block::kSize, cells.size() - first);
    load_corners(sites, cells.subspan(first, size), block);
    faces_here(block, tolerance, found.data());
    for (std::size_t i = 0; i < size; ++i) {
      faces[first + i] = (found[i] & 1) == 0 ? static_cast<std::uint16_t>(found[i])
                                             : faces_of_one<D>(sites, cells[first + i]);
    }
  }
}

#define ORTHOBALL_INSTANTIATE_ATTACHED_FACES(D, CORNERS)                                           \
  template void attached_faces<D, CORNERS>(const Sites<D>&, std::span<const CornerSites<CORNERS>>, \
                                           std::span<std::uint16_t>);
ORTHOBALL_INSTANTIATE_ATTACHED_FACES(2, 2)
ORTHOBALL_INSTANTIATE_ATTACHED_FACES(2, 3)
ORTHOBALL_INSTANTIATE_ATTACHED_FACES(3, 2)
ORTHOBALL_INSTANTIATE_ATTACHED_FACES(3, 3)
ORTHOBALL_INSTANTIATE_ATTACHED_FACES(3, 4)
#undef ORTHOBALL_INSTANTIATE_ATTACHED_FACES

}  // namespace orthoball
