// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iosfwd>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace orthoball {

/// Bytes could not be written: the device is full, the pipe is closed.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Text and numbers on their way to a stream, handed over in pieces of a megabyte.
///
/// Nothing is written by the destructor: whoever fills a sink calls flush() at the end. Does not
/// own the stream.
class ByteSink {
 public:
  /// @param missing  what stands for a number that is not finite: "null" in JSON.
  explicit ByteSink(std::ostream& out, std::string_view missing = {});

  /// @throws OutputError here and below, when a piece could not be written.
  void text(std::string_view text) {
    if (text.size() > room()) return long_text(text);
    std::copy_n(text.data(), text.size(), at_);
    at_ += text.size();
  }
  /// The shortest decimal text that reads back to the same double; `missing` for NaN and infinity.
  void real(double number);
  /// `missing` where there is no number to write; not counted.
  void none() { text(missing_); }
  void integer(std::int64_t number);
  /// `text` as a JSON string, quotes included; U+FFFD for bytes that are not UTF-8.
  void json_string(std::string_view text);
  /// `number` as its bytes, the lowest first.
  template <class T>
  void little_endian(T number) {
    static_assert(std::is_arithmetic_v<T>);
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &number, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    text({bytes.data(), bytes.size()});
  }
  /// Hands over everything that was collected.
  void flush();

  /// How many numbers were not finite.
  [[nodiscard]] std::size_t missing_count() const { return missing_count_; }

 private:
  [[nodiscard]] std::size_t room() const { return static_cast<std::size_t>(end_ - at_); }
  void long_text(std::string_view text);

  static constexpr std::size_t kPiece = std::size_t{1} << 20U;
  std::ostream& out_;
  std::string missing_;
  std::unique_ptr<char[]> buffer_;
  char* at_;  // the free rest of the buffer
  char* end_;
  std::size_t missing_count_ = 0;
};

/// The shortest decimal text that reads back to the same double.
[[nodiscard]] std::string shortest_text(double number);

}  // namespace orthoball
