// SPDX-License-Identifier: MIT
//
// A site in space is four numbers in a row, so four simplices' sites are a square of numbers that
// vectors turn over.
#include "orthoball/exact/corner_block.h"

#include "orthoball/exact/processor.h"

namespace orthoball {
namespace {

template <int D, std::size_t Corners>
void load_from(std::size_t first, const Sites<D>& sites,
               std::span<const CornerSites<Corners>> simplices, CornerBlock<D, Corners>& block) {
  for (std::size_t i = first; i < simplices.size(); ++i) {
    for (std::size_t corner = 0; corner < Corners; ++corner) {
      const Site<D>& site = sites[simplices[i][corner]];
      for (std::size_t axis = 0; axis < D; ++axis) block.x[corner][axis][i] = site.x[axis];
      block.weight[corner][i] = site.weight;
    }
  }
}

#ifdef ORTHOBALL_WIDE_CODE

using Four = double __attribute__((vector_size(32)));

[[gnu::always_inline]] ORTHOBALL_AVX2 inline Four loaded(const Site<3>& site) {
  Four four;
  static_assert(sizeof four == sizeof site);
  __builtin_memcpy(&four, &site, sizeof four);
  return four;
}
[[gnu::always_inline]] ORTHOBALL_AVX2 inline void store(double* numbers, const Four& four) {
  __builtin_memcpy(numbers, &four, sizeof four);
}

template <std::size_t Corners>
ORTHOBALL_AVX2 void load_in_fours(const Sites<3>& sites,
                                  std::span<const CornerSites<Corners>> simplices,
                                  CornerBlock<3, Corners>& block) {
  const std::size_t fours = simplices.size() / 4 * 4;
  for (std::size_t i = 0; i < fours; i += 4) {
    for (std::size_t corner = 0; corner < Corners; ++corner) {
      const Four a = loaded(sites[simplices[i][corner]]);
      const Four b = loaded(sites[simplices[i + 1][corner]]);
      const Four c = loaded(sites[simplices[i + 2][corner]]);
      const Four d = loaded(sites[simplices[i + 3][corner]]);
      const Four ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6);
      const Four ab_yw = __builtin_shufflevector(a, b, 1, 5, 3, 7);
      const Four cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6);
      const Four cd_yw = __builtin_shufflevector(c, d, 1, 5, 3, 7);
      store(&block.x[corner][0][i], __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5));
      store(&block.x[corner][1][i], __builtin_shufflevector(ab_yw, cd_yw, 0, 1, 4, 5));
      store(&block.x[corner][2][i], __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7));
      store(&block.weight[corner][i], __builtin_shufflevector(ab_yw, cd_yw, 2, 3, 6, 7));
    }
  }
  load_from(fours, sites, simplices, block);
}

#endif

}  // namespace

template <int D, std::size_t Corners>
void load_corners(const Sites<D>& sites, std::span<const CornerSites<Corners>> simplices,
                  CornerBlock<D, Corners>& block) {
#ifdef ORTHOBALL_WIDE_CODE
  if constexpr (D == 3) {
    if (has_avx2()) return load_in_fours(sites, simplices, block);
  }
#endif
  load_from(0, sites, simplices, block);
}

#define ORTHOBALL_INSTANTIATE_LOAD(D, CORNERS)                                                   \
  template void load_corners<D, CORNERS>(const Sites<D>&, std::span<const CornerSites<CORNERS>>, \
                                         CornerBlock<D, CORNERS>&);
ORTHOBALL_INSTANTIATE_LOAD(2, 2)
ORTHOBALL_INSTANTIATE_LOAD(2, 3)
ORTHOBALL_INSTANTIATE_LOAD(3, 2)
ORTHOBALL_INSTANTIATE_LOAD(3, 3)
ORTHOBALL_INSTANTIATE_LOAD(3, 4)
#undef ORTHOBALL_INSTANTIATE_LOAD

}  // namespace orthoball
