// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// The page of the viewer as it was built into the program, with places for a title and for the
/// data. Empty where the program was built without.
[[nodiscard]] std::string_view viewer_page();
