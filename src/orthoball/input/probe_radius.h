// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "orthoball/points/probe.h"

namespace orthoball {

/// The radius of a probe as a decimal text says it, so that "1.4" is seven fifths.
/// @throws InputError for a text that is no finite number, and for one below 0.
[[nodiscard]] ProbeRadius probe_radius(std::string_view text);

}  // namespace orthoball
