// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace orthoball {

/// `text` with &, <, > and quotes written as entities. What is not UTF-8, or no character of XML,
/// becomes U+FFFD; control characters become blanks.
[[nodiscard]] std::string xml_text(std::string_view text);

/// About how many pixels `text` takes in a sans-serif font of that size; seldom too few.
[[nodiscard]] double text_width(std::string_view text, double font_size);

/// `text`, or as much of its begin as fits into `width` pixels with "…" behind it.
[[nodiscard]] std::string shortened(std::string_view text, double width, double font_size);

}  // namespace orthoball
