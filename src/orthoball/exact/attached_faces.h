// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "orthoball/exact/orthoradius.h"
#include "orthoball/exact/sites.h"

namespace orthoball {

/// Which proper faces of each cell are attached by one of its other corners: bit m of `faces[i]`,
/// where m is a set of corners (bit c for corner c), stands for the face of `cells[i]` with these,
/// and is set where another corner has less power than the squared orthoradius at its orthocentre.
/// Bits that stand for no proper face are 0.
///
/// Exact; a tie is not attached. Of the corners beside a face those decide that make its cofaces,
/// so what no cell attaches is unattached. 2 to D + 1 corners. Vector instructions where the
/// machine has them; the same bits everywhere.
template <int D, std::size_t Corners>
void attached_faces(const Sites<D>& sites, std::span<const CornerSites<Corners>> cells,
                    std::span<std::uint16_t> faces);

}  // namespace orthoball
