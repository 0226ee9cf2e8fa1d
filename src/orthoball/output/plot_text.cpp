// SPDX-License-Identifier: MIT
#include "orthoball/output/plot_text.h"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace orthoball {
namespace {

constexpr std::string_view kReplacement = "\uFFFD", kEllipsis = "\u2026";

// One character of a text: its bytes and its number, or a byte that begins none.
struct Character {
  std::string_view bytes;
  std::uint32_t code;
  bool is_valid;
};

// UTF-8 in its shortest form, without surrogates.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto length = static_cast<std::size_t>(std::countl_one(byte(0)));
  if (length == 0) return {text.substr(0, 1), byte(0), true};
  const Character invalid{text.substr(0, 1), 0xFFFD, false};
  if (length == 1 || length > 4 || length > text.size()) return invalid;
  std::uint32_t code = byte(0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (byte(i) >> 6U != 2U) return invalid;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0x80, 0x800, 0x10000};
  const bool is_character = code >= kLeast[length - 2] && code <= 0x10FFFF &&
                            !(code >= 0xD800 && code <= 0xDFFF) && code != 0xFFFE && code != 0xFFFF;
  return is_character ? Character{text.substr(0, length), code, true} : invalid;
}

template <class Use>
void for_each_character(std::string_view text, const Use& use) {
  while (!text.empty()) {
    const Character character = first_character(text);
    use(character);
    text.remove_prefix(character.bytes.size());
  }
}

// Of the size of the font, as in Helvetica and a little more for fonts that stand in for it.
double width_of(std::uint32_t code) {
  constexpr std::string_view kNarrow = " !'(),-./:;I[]fijlrt|", kWide = "%@MWmw";
  const bool is_ascii = code < 0x80;
  if (is_ascii && kNarrow.find(static_cast<char>(code)) != std::string_view::npos) return 0.36;
  if (is_ascii && kWide.find(static_cast<char>(code)) != std::string_view::npos) return 0.97;
  if (code >= 'A' && code <= 'Z') return 0.72;
  constexpr std::uint32_t kFirstOfFullWidth = 0x1100;  // Hangul, then CJK and its like
  return code < kFirstOfFullWidth ? 0.62 : 1.0;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string escaped;
  for_each_character(text, [&](const Character& character) {
    switch (character.code) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += !character.is_valid     ? kReplacement
                   : character.code < 0x20 ? std::string_view(" ")
                                           : character.bytes;
    }
  });
  return escaped;
}

double text_width(std::string_view text, double font_size) {
  double width = 0.0;
  for_each_character(
      text, [&](const Character& character) { width += font_size * width_of(character.code); });
  return width;
}

std::string shortened(std::string_view text, double width, double font_size) {
  if (text_width(text, font_size) <= width) return std::string(text);
  double room = width - text_width(kEllipsis, font_size);
  std::string begin;
  for_each_character(text, [&](const Character& character) {
    room -= font_size * width_of(character.code);
    if (room >= 0.0) begin += character.bytes;
  });
  return begin.append(kEllipsis);
}

}  // namespace orthoball
