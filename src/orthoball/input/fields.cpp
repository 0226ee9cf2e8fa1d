// SPDX-License-Identifier: MIT
#include "orthoball/input/fields.h"

#include <limits>
#include <string>

#include "orthoball/error.h"

namespace orthoball {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

}  // namespace

DecimalNumber number_at(const Source& source, std::size_t line, std::string_view text,
                        std::string_view what) {
  const DecimalParse parse = parse_decimal(text);
  if (parse.fault == DecimalFault::none) return parse.number;
  const std::string found = std::string(what) + " is " + quoted(text);
  switch (parse.fault) {
    case DecimalFault::not_finite:
      throw ParseError(source.name, line, found + "; a finite number is needed");
    case DecimalFault::out_of_range:
      throw ParseError(source.name, line,
                       found + ", which is out of range; numbers must be below 1.8e308 in size");
    default:
      throw ParseError(source.name, line,
                       found + ", which is not a number; a number such as -1.25 is needed");
  }
}

std::size_t count_at(const Source& source, std::size_t line, std::string_view text,
                     std::string_view what) {
  constexpr auto kLargest = static_cast<std::size_t>(std::numeric_limits<std::int64_t>::max());
  std::size_t count = 0;
  bool is_count = !text.empty();
  for (const char c : text) {
    if (c < '0' || c > '9') {
      is_count = false;
      break;
    }
    const auto digit = static_cast<std::size_t>(c - '0');
    if (count > (kLargest - digit) / 10) {
      throw ParseError(source.name, line,
                       std::string(what) + " is " + quoted(text) + ", which is out of range");
    }
    count = 10 * count + digit;
  }
  if (is_count) return count;
  throw ParseError(source.name, line,
                   std::string(what) + " is " + quoted(text) + "; a whole number is needed");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  const char* at = line.data();
  const char* const end = at + line.size();
  for (;;) {
    while (at != end && is_blank(*at)) ++at;
    if (at == end) return;
    const char* const begin = at;
    while (at != end && !is_blank(*at)) ++at;
    fields.emplace_back(begin, static_cast<std::size_t>(at - begin));
  }
}

}  // namespace orthoball
