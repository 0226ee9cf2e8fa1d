// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "orthoball/points/weighted_points.h"

namespace orthoball::benchmarks {

/// The input of a benchmark by the name of its family, rows in random order. The same arguments
/// make the same bytes in every program. Families of tests/generators/point_families, and
///
///   fixed_point   integers in [0, 100000], uniform, five decimals
///   noisy_sphere  on the unit sphere (circle), but for a radial noise of 0.001
///   atoms         a jittered lattice of 0.1 atoms per cubic angstrom (square: the same
///   spacing), 1.2
///                 angstrom apart at least, three decimals, radii of five elements; none is hidden
///   hidden        uniform centres, radii uniform in [0, 1.5 n^(-1/D)]: in space 38 % are hidden
///
/// @throws std::invalid_argument for another name.
[[nodiscard]] WeightedPoints input(const std::string& family, int dimension, std::size_t count);

/// A number that differs where inputs do: programs that print the same were given the same bytes.
[[nodiscard]] std::uint64_t fingerprint(const WeightedPoints& points);

}  // namespace orthoball::benchmarks
