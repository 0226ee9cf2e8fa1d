// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "orthoball/output/byte_sink.h"
#include "orthoball/queries/pockets.h"

namespace orthoball {

/// What a pocket is by the number of its mouths: "void" (none), "pocket" (one) or "channel".
[[nodiscard]] std::string_view pocket_kind(const Pocket& pocket);

/// Pockets as CSV: `pocket,kind,volume,area,depth,atoms,mouths,mouth_areas`, one line a pocket in
/// the order given, numbered from 1. `atoms` are the input rows of the lining balls, from 0,
/// `mouth_areas` those of the mouths, both with blanks between; a void has no depth. Numbers beyond
/// the double range are left empty.
void write_pockets_csv(ByteSink& sink, std::span<const Pocket> pockets);

}  // namespace orthoball
