// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/exact/processor.h"

#ifdef ORTHOBALL_WIDE_CODE

#include <array>
#include <cstdint>
#include <cstring>

#include "orthoball/exact/sites.h"

/// Vectors of four doubles, for functions marked ORTHOBALL_AVX2.
namespace orthoball::four_lanes {

/// Four doubles.
using Four = double __attribute__((vector_size(32)));
/// What comparisons of them give: all bits of a lane or none.
using FourBits = std::int64_t __attribute__((vector_size(32)));

/// The coordinates and the weight.
[[gnu::always_inline]] ORTHOBALL_AVX2 inline Four loaded(const Site<3>& site) {
  Four four;
  static_assert(sizeof four == sizeof site);
  std::memcpy(&four, &site, sizeof four);
  return four;
}
[[gnu::always_inline]] ORTHOBALL_AVX2 inline Four all(double number) {
  return Four{number, number, number, number};
}
[[gnu::always_inline]] ORTHOBALL_AVX2 inline Four absolute(Four a) {
  const FourBits bits = {INT64_MAX, INT64_MAX, INT64_MAX, INT64_MAX};
  return reinterpret_cast<Four>(reinterpret_cast<FourBits>(a) & bits);
}
/// Bit i is the sign of lane i.
[[gnu::always_inline]] ORTHOBALL_AVX2 inline std::uint32_t signs(FourBits lanes) {
  return static_cast<std::uint32_t>(__builtin_ia32_movmskpd256(reinterpret_cast<Four>(lanes)));
}
/// Lane i has what lane i ^ 1 had.
[[gnu::always_inline]] ORTHOBALL_AVX2 inline Four turned1(Four a) {
  return __builtin_shufflevector(a, a, 1, 0, 3, 2);
}
/// Lane i has what lane i ^ 2 had.
[[gnu::always_inline]] ORTHOBALL_AVX2 inline Four turned2(Four a) {
  return __builtin_shufflevector(a, a, 2, 3, 0, 1);
}

/// Four sites less another, a column to a vector.
struct Columns {
  Four x, y, z, weight;
};

/// The columns of these sites with the origin moved.
[[gnu::always_inline]] ORTHOBALL_AVX2 inline Columns columns(
    const Sites<3>& sites, const std::array<std::uint32_t, 4>& corners, Four origin) {
  const Four a = loaded(sites[corners[0]]) - origin;
  const Four b = loaded(sites[corners[1]]) - origin;
  const Four c = loaded(sites[corners[2]]) - origin;
  const Four d = loaded(sites[corners[3]]) - origin;
  const Four ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four ab_yw = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four cd_yw = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5),
          __builtin_shufflevector(ab_yw, cd_yw, 0, 1, 4, 5),
          __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7),
          __builtin_shufflevector(ab_yw, cd_yw, 2, 3, 6, 7)};
}

}  // namespace orthoball::four_lanes

#endif
