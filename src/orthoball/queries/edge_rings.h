// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orthoball {

/// A cycle of edges, each given by its two vertices, as rings that visit no vertex twice; a ring is
/// closed from its last vertex to its first. Walks begin at the smallest vertex left and go to the
/// smallest; a ring is cut off where a walk comes back to where it was.
/// @param edges  of which every vertex has an even number.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> edge_rings(
    std::span<const std::array<std::uint32_t, 2>> edges);

}  // namespace orthoball
