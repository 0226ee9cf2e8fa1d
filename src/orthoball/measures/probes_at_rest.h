// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/lens.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// What a probe has of the union of accessible balls while it rests on three of them, where it is
/// nearer than any other.
struct ProbePart {
  double volume = 0.0;       ///< length^3
  double solid_angle = 0.0;  ///< of its sphere, in steradians
};

/// The parts of all probes at rest, to be added up. One rests on every triangle on the boundary of
/// the complex, on each side where no cell of the complex lies; its centre is where the three
/// spheres meet there.
///
/// Its part is that of its ball in the tetrahedron over the triangle. Where it reaches through the
/// triangle, it is cut at the planes half way to the other probes that do, and has another part, in
/// the cells of the complex behind: followed from cell to cell as far as it goes.
///
/// Nearly linear for balls and probes of molecules. In general every part takes the cells that it
/// reaches times the probes that it borders on, and every one of m probes at one place the cells
/// behind all. The same on any number of threads.
/// @param spheres  [vertex]: the accessible balls.
/// @param radius   of the probe, >= 0.
[[nodiscard]] std::vector<ProbePart> probes_at_rest(const Filtration<3>& filtration,
                                                    std::uint32_t index,
                                                    std::span<const Sphere<3>> spheres,
                                                    double radius, Threads threads);

}  // namespace orthoball
