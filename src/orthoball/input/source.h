// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "orthoball/memory_budget.h"

namespace orthoball {

/// The bytes of one input, decompressed, with the name that messages use.
struct Source {
  std::string name;   ///< the path as given, "-" for standard input
  std::string bytes;  ///< after gunzip, without a UTF-8 byte order mark
};

/// Largest input accepted unless limits are lifted: 1 GiB uncompressed, compression ratio 200. What
/// decompresses to 1 MiB or less is within the ratio in any case.
inline constexpr std::size_t kLargestInput = std::size_t{1} << 30U;
inline constexpr std::size_t kLargestCompressionRatio = 200;

/// Reads a file, or standard input for "-". gzip is recognised by its first bytes, whatever the
/// name; bz2, xz, zstd, lz4, 7z and zip are refused by name with how to convert.
/// @throws ParseError if it cannot be opened or read, is truncated or corrupt gzip, or (when
///         `limited`) is larger than the limits above. Memory stays within a small multiple of the
///         limit, whatever the bytes claim.
/// @throws LimitError for a file that is larger than `memory` allows.
[[nodiscard]] Source read_source(const std::string& path, bool limited,
                                 const MemoryBudget& memory = {});

/// Refuses what is not a text: NUL bytes (with the line), UTF-16, PNG and other known signatures.
/// Messages print no raw bytes.
/// @throws ParseError
void require_text(const Source& source);

/// The lines of a text, one after the other: ends are \n, \r\n or \r. O(length) in total.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}
  /// False at the end of the text; otherwise `line` is the next line without its end.
  [[nodiscard]] bool next(std::string_view& line);
  /// 1-based number of the line last returned.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Passes over `count` lines, which end where `rest` begins; a tail of what rest() gave.
  void skip(std::size_t count, std::string_view rest) {
    at_ = text_.size() - rest.size();
    number_ += count;
  }
  /// What follows the line last returned and its end.
  [[nodiscard]] std::string_view rest() const { return text_.substr(std::min(at_, text_.size())); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;  // where the next line begins
  // The first \n and \r at or after at_, once found; text_.size() if none.
  std::size_t newline_ = 0;
  std::size_t carriage_ = 0;
  bool is_searched_ = false;
  std::size_t number_ = 0;
};

/// At most 40 characters of `text`, what is not printable ASCII as \xNN. For messages.
[[nodiscard]] std::string printable(std::string_view text);

/// The same in quotes.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace orthoball
