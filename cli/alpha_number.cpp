// SPDX-License-Identifier: MIT
//
// X = n 10^e with an integer n of any length. X|X| = n|n| 10^(2e) is written out as decimal text
// again and read by the library, which rounds correctly. A quotient is first cut after kDigits
// digits; a digit 1 behind them says that something was cut, and since the midpoint of two doubles
// never has that many digits, rounding the text rounds the quotient.

#include "cli/alpha_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "cli/usage_error.h"
#include "orthoball/input/decimal.h"

namespace {

using Integer = boost::multiprecision::cpp_int;

constexpr int kDigits = 800;  // midpoints of doubles have at most 767
constexpr std::size_t kLongestText = 4000;

struct Decimal {
  bool is_negative = false;
  Integer digits;
  std::int64_t exponent = 0;
};

// The double nearest to `decimal`, which is what was typed, or `made` of it and then needs a text
// that is as `needed`.
double checked(const std::string& option, const std::string& text, const std::string& decimal,
               const std::string& made = {},
               const std::string& needed = "a finite decimal number") {
  const orthoball::DecimalParse parse = orthoball::parse_decimal(decimal);
  if (parse.fault == orthoball::DecimalFault::none) return parse.number.nearest;
  const std::string fault = parse.fault == orthoball::DecimalFault::not_a_number ? "not a number"
                            : parse.fault == orthoball::DecimalFault::not_finite
                                ? "not finite"
                                : "beyond the range of a double";
  throw UsageError(fmt::format("{}: {}\"{}\" is {}; {} is needed", option, made, text.substr(0, 40),
                               fault, needed));
}

// The parts of a text that `checked` has accepted.
Decimal parts(const std::string& text) {
  Decimal decimal;
  std::string digits;
  std::size_t i = 0;
  bool after_point = false;
  for (; i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) == 0; ++i) {
    if (text[i] == '-') decimal.is_negative = true;
    if (text[i] == '.') after_point = true;
    if (std::isdigit(static_cast<unsigned char>(text[i])) == 0) continue;
    digits += text[i];
    if (after_point) --decimal.exponent;
  }
  if (i < text.size()) decimal.exponent += std::stoll(text.substr(i + 1));
  // A leading zero would make the digits octal.
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  if (!digits.empty()) decimal.digits = Integer(digits);
  return decimal;
}

std::string text_of(const Integer& digits, std::int64_t exponent, bool is_negative) {
  return fmt::format("{}{}e{}", is_negative ? "-" : "", digits.str(), exponent);
}

void check_length(const std::string& option, const std::string& text) {
  if (text.size() > kLongestText) {
    throw UsageError(option + ": a number of " + std::to_string(text.size()) +
                     " characters; at most " + std::to_string(kLongestText) + " are read");
  }
}

}  // namespace

double alpha2_from_text(const std::string& option, const std::string& text) {
  return checked(option, text, text);
}

double alpha2_from_alpha(const std::string& option, const std::string& text) {
  check_length(option, text);
  if (checked(option, text, text) == 0.0 && parts(text).digits == 0) return 0.0;
  const Decimal x = parts(text);
  return checked(option, text, text_of(x.digits * x.digits, 2 * x.exponent, x.is_negative),
                 "the square of ", "a number below 1.34e154 in size");
}

double alpha2_from_inverse_alpha(const std::string& option, const std::string& text) {
  check_length(option, text);
  (void)checked(option, text, text);
  const Decimal x = parts(text);
  if (x.digits == 0) {
    throw UsageError(option + ": 0 has no inverse; use a large --alpha2 for the whole hull");
  }
  const Integer square = x.digits * x.digits;
  const auto shift = static_cast<unsigned>(square.str().size() + kDigits);
  Integer quotient, rest;
  divide_qr(Integer(pow(Integer(10), shift)), square, quotient, rest);
  std::int64_t exponent = -2 * x.exponent - static_cast<std::int64_t>(shift);
  if (rest != 0) {
    quotient = 10 * quotient + 1;
    --exponent;
  }
  return checked(option, text, text_of(quotient, exponent, x.is_negative), "the inverse square of ",
                 "a number above 7.46e-155 in size");
}
