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
  for (const char c : string) {
    if (c == '"' || c == '\\') {
      const std::array<char, 2> escaped{'\\', c};
      text({escaped.data(), escaped.size()});
    } else if (static_cast<unsigned char>(c) < 0x20) {
      text(fmt::format("\\u{:04x}", static_cast<unsigned>(c)));
    } else {
      text({&c, 1});
    }
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
