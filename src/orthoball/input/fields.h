// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/counted.h"
#include "orthoball/input/decimal.h"
#include "orthoball/input/source.h"

namespace orthoball {

/// The number that the whole of `text` spells, from line `line` of `source`.
/// @param what  names it in messages: "x", "column 3".
/// @throws ParseError `FILE:LINE: x is "12.3x4", which is not a number; ...`
[[nodiscard]] DecimalNumber number_at(const Source& source, std::size_t line, std::string_view text,
                                      std::string_view what);

/// The number of things a file announces: digits and nothing else. Nothing may be reserved by it
/// before it is compared with the bytes that are there.
/// @throws ParseError for signs, other characters, 2^63 and more.
[[nodiscard]] std::size_t count_at(const Source& source, std::size_t line, std::string_view text,
                                   std::string_view what);

/// `text` without blanks and tabs at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Replaces `fields` by the pieces of `line` between blanks and tabs, none of them empty.
void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields);

}  // namespace orthoball
