// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace orthoball {

/// What the plain rows of a format look like: numbers as most files write them between separators,
/// without quotes, comments and faults.
struct PlainRows {
  static constexpr char kBlanks = ' ';  ///< any run of blanks and tabs

  char separator = kBlanks;  ///< between fields; blanks beside it do not count
  std::string_view mark{};   ///< what each row begins with, followed by a blank
  std::size_t most = static_cast<std::size_t>(-1);  ///< rows to take
};

/// A column whose fields are passed over.
inline constexpr std::uint8_t kUnusedColumn = 255;

/// Reads one row in a single pass over its bytes.
/// @param at, end  where the row begins, and the end of the whole text.
/// @param slots    [column]: where in `numbers` its number goes, or kUnusedColumn.
/// @param parse    `const char* parse(const char* at, const char* end, Number& number)`: reads the
///                 number at `at`, gives its end; null where there is none.
/// @return the end of the row's line; null, with anything in `numbers`, for a row that is not
///         plain, not of these columns, or perhaps a comment.
template <class Number, class Parse>
const char* read_plain_row(const char* at, const char* end, const PlainRows& plain,
                           std::span<const std::uint8_t> slots, Number* numbers,
                           const Parse& parse) {
  const bool is_separated = plain.separator != PlainRows::kBlanks;
  const auto skip_blanks = [&] {
    while (at != end && (*at == ' ' || (*at == '\t' && plain.separator != '\t'))) ++at;
  };
  skip_blanks();
  if (!plain.mark.empty()) {
    if (static_cast<std::size_t>(end - at) <= plain.mark.size() ||
        std::string_view(at, plain.mark.size()) != plain.mark) {
      return nullptr;
    }
    at += plain.mark.size();
    if (*at != ' ' && *at != '\t') return nullptr;
    skip_blanks();
  }
  // The marks of comments.
  if (at != end && (*at == '%' || *at == '/')) return nullptr;
  for (std::size_t column = 0; column < slots.size(); ++column) {
    if (column > 0) {
      if (is_separated) {
        if (at == end || *at != plain.separator) return nullptr;
        ++at;
      } else if (at[-1] != ' ' && at[-1] != '\t') {
        return nullptr;
      }
      skip_blanks();
    }
    if (slots[column] != kUnusedColumn) {
      at = parse(at, end, numbers[slots[column]]);
      if (at == nullptr) return nullptr;
    } else {
      const char* const begin = at;
      while (at != end && *at != plain.separator &&
             (static_cast<unsigned char>(*at) > ' ' || (is_separated && *at == ' '))) {
        if (*at == '"' || *at == '#') return nullptr;
        ++at;
      }
      if (!is_separated && at == begin) return nullptr;
    }
    skip_blanks();
  }
  if (at == end) return at;
  if (*at == '\r') ++at;
  return at != end && *at == '\n' ? at + 1 : nullptr;
}

}  // namespace orthoball
