// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "orthoball/input/source.h"

namespace orthoball {

/// A part of a CIF file.
struct CifToken {
  /// What it is.
  enum class Kind { block, loop, loop_tag, loop_value, loop_end, item_tag, item_value };

  Kind kind = Kind::block;
  std::string_view text;     ///< a name, a tag, or a value without quotes, empty for "." and "?"
  std::string_view written;  ///< as it stands in the file
  std::size_t line = 0;      ///< 1-based
};

/// Gives `take` the parts of a CIF file one after the other, views into `text`. Linear in its
/// length, with a flat stack, whatever the bytes are.
/// @param source  names the file in messages.
/// @throws ParseError with the line for what is not CIF, and what `take` throws.
void read_cif_tokens(const Source& source, std::string_view text,
                     const std::function<void(const CifToken&)>& take);

}  // namespace orthoball
