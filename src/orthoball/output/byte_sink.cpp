// SPDX-License-Identifier: MIT
#include "orthoball/output/byte_sink.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <ostream>

namespace orthoball {
namespace {

// The bytes of the character in UTF-8 that a text begins with; 0 where it begins with none.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t size = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned second = byte(1);
  const bool is_overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool is_beyond = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return is_overlong || is_beyond ? 0 : size;
}

constexpr std::size_t kLongestNumber = 32;

// "000102...99"
constexpr std::array<char, 200> kPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

}  // namespace

ByteSink::ByteSink(std::ostream& out, std::string_view missing)
    : out_(out),
      missing_(missing),
      buffer_(new char[kPiece]),  // not filled: small outputs touch little of it
      at_(buffer_.get()),
      end_(at_ + kPiece) {}

void ByteSink::real(double number) {
  if (!std::isfinite(number)) {
    ++missing_count_;
    return text(missing_);
  }
  if (room() < kLongestNumber) flush();
  at_ = fmt::format_to(at_, FMT_COMPILE("{}"), number + 0.0);
}

void ByteSink::integer(std::int64_t number) {
  if (room() < kLongestNumber) flush();
  auto rest = static_cast<std::uint64_t>(number);
  if (number < 0) {
    *at_++ = '-';
    rest = 0 - rest;
  }
  // Figures in pairs from the last on, then as many bytes as there can be to their place.
  constexpr std::size_t kMostFigures = 20;
  std::array<char, 2 * kMostFigures> figures{};
  char* const end = figures.data() + kMostFigures;
  char* first = end;
  for (; rest >= 100; rest /= 100) {
    first -= 2;
    std::copy_n(&kPairs[2 * (rest % 100)], 2, first);
  }
  first -= 2;
  std::copy_n(&kPairs[2 * rest], 2, first);
  if (rest < 10) ++first;
  std::copy_n(first, kMostFigures, at_);
  at_ += end - first;
}

void ByteSink::json_string(std::string_view string) {
  text("\"");
  while (!string.empty()) {
    const char c = string[0];
    const std::size_t size = character_size(string);
    if (c == '"' || c == '\\') {
      const std::array<char, 2> escaped{'\\', c};
      text({escaped.data(), escaped.size()});
    } else if (static_cast<unsigned char>(c) < 0x20) {
      text(fmt::format("\\u{:04x}", static_cast<unsigned>(c)));
    } else {
      text(size == 0 ? "\xEF\xBF\xBD" : string.substr(0, size));
    }
    string.remove_prefix(std::max<std::size_t>(1, size));
  }
  text("\"");
}

void ByteSink::long_text(std::string_view text) {
  flush();
  if (text.size() <= kPiece) return this->text(text);
  out_.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!out_) throw OutputError("could not be written");
}

void ByteSink::flush() {
  out_.write(buffer_.get(), at_ - buffer_.get());
  at_ = buffer_.get();
  if (!out_) throw OutputError("could not be written");
}

std::string shortest_text(double number) { return fmt::format("{}", number + 0.0); }

}  // namespace orthoball
