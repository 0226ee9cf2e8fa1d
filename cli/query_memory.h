// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

// Peaks of memory of what is asked of a filtration, beyond it, in bytes. Measured on random points
// at several alphas, on one thread and on two; representatives on shaken lattices, too.

/// Of the candidates for alpha.
[[nodiscard]] std::uint64_t candidates_memory(int dimension, std::size_t simplices);
/// Of finding them again in parts of the sites, one after the other.
[[nodiscard]] std::uint64_t resamples_memory(int dimension, std::size_t sites,
                                             std::size_t simplices);
/// Of a solid with a closed surface, and its mesh.
[[nodiscard]] std::uint64_t manifold_memory(int dimension, std::size_t simplices);
/// Of locating so many points.
[[nodiscard]] std::uint64_t locate_memory(int dimension, std::size_t simplices, std::size_t points);
/// Of finding what makes classes of homology, with the pairs, but for what is found.
[[nodiscard]] std::uint64_t representatives_memory(int dimension, std::size_t simplices);
