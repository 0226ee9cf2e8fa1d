// SPDX-License-Identifier: MIT
#include "orthoball/output/byte_sink.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <ostream>

namespace orthoball {

ByteSink::ByteSink(std::ostream& out, std::string_view missing) : out_(out), missing_(missing) {
  buffer_.reserve(kPiece + 256);
}

void ByteSink::real(double number) {
  if (!std::isfinite(number)) {
    ++missing_count_;
    return text(missing_);
  }
  std::array<char, 32> digits;
  const char* const end = fmt::format_to(digits.data(), FMT_COMPILE("{}"), number + 0.0);
  text({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

void ByteSink::integer(std::int64_t number) {
  const fmt::format_int digits(number);
  text({digits.data(), digits.size()});
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

void ByteSink::through(std::string_view text) {
  flush();
  out_.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!out_) throw OutputError("could not be written");
}

void ByteSink::flush() {
  out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  buffer_.clear();
  if (!out_) throw OutputError("could not be written");
}

std::string shortest_text(double number) { return fmt::format("{}", number + 0.0); }

}  // namespace orthoball
