// SPDX-License-Identifier: MIT
#include "orthoball/input/short_decimal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "generators/random.h"
#include "orthoball/input/decimal.h"

namespace orthoball {
namespace {

// Digits, decimals and how many characters were read; "none" where there is no number.
std::string reading_of(const std::string& text) {
  ShortDecimal number;
  const char* const end = parse_short_decimal(text.data(), text.data() + text.size(), number);
  if (end == nullptr) return "none";
  return std::to_string(number.digits) + "e-" + std::to_string(number.decimals) + " " +
         std::to_string(end - text.data());
}

TEST(ParseShortDecimal, KeepsTheDigitsAsWritten) {
  EXPECT_EQ(reading_of("0"), "0e-0 1");
  EXPECT_EQ(reading_of("-12.500,"), "-12500e-3 7");
  EXPECT_EQ(reading_of("+.5 "), "5e-1 3");
  EXPECT_EQ(reading_of("7."), "7e-0 2");
  EXPECT_EQ(reading_of("1.5e-3"), "15e-4 6");
  EXPECT_EQ(reading_of("2E+02\n"), "2e--2 5");
  EXPECT_EQ(reading_of("123456789012345678"), "123456789012345678e-0 18");
  EXPECT_EQ(reading_of("-12345678.1234567890"), "-123456781234567890e-10 20");
}

TEST(ParseShortDecimal, LeavesOtherTextsAlone) {
  for (const char* const text : {"",
                                 "-",
                                 "+",
                                 ".",
                                 "-.",
                                 "x",
                                 " 1",
                                 "--1",
                                 "+-1",
                                 "nan",
                                 "inf",
                                 "1234567890123456789",
                                 "0.1234567890123456789",
                                 "1e",
                                 "1e+",
                                 "1e-",
                                 "1e1000",
                                 "1e281",
                                 "e5",
                                 "\xC2\xBD"}) {
    EXPECT_EQ(reading_of(text), "none") << text;
  }
  EXPECT_EQ(reading_of("1d5"), "1e-0 1");  // what follows is for the caller to see
  EXPECT_EQ(reading_of("1.2.3"), "12e-1 3");
  EXPECT_EQ(reading_of("12:"), "12e-0 2");
  EXPECT_EQ(reading_of("12/"), "12e-0 2");
}

TEST(ParseShortDecimal, ReadsEveryLengthOfRunsAtEveryDistanceFromTheEnd) {
  const std::string figures = "123456789123456789";
  for (std::size_t whole = 0; whole <= 18; ++whole) {
    for (std::size_t fraction = whole == 0 ? 1 : 0; whole + fraction <= 18; ++fraction) {
      const std::string text = figures.substr(0, whole) + "." + figures.substr(whole, fraction);
      const std::string expected = std::to_string(std::stoll(figures.substr(0, whole + fraction))) +
                                   "e-" + std::to_string(fraction) + " " +
                                   std::to_string(text.size());
      for (const char* const behind : {"", ",", " 12345678", "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF"}) {
        EXPECT_EQ(reading_of(text + behind), expected) << text + behind;
      }
    }
  }
}

TEST(ParseShortDecimal, AgreesWithTheGeneralParser) {
  generators::Random random(3);
  const std::string letters = "0123456789012345678901234567890.-+eE";
  for (int i = 0; i < 200'000; ++i) {
    std::string text;
    for (int length = random.integer(1, 14); length > 0; --length) {
      text += letters[static_cast<std::size_t>(
          random.integer(0, static_cast<int>(letters.size()) - 1))];
    }
    ShortDecimal number;
    const char* const end = parse_short_decimal(text.data(), text.data() + text.size(), number);
    if (end != text.data() + text.size()) continue;
    // Many zeros behind the point make it long, and change nothing.
    std::size_t exponent = std::min(text.find_first_of("eE"), text.size());
    std::string longer = text.substr(0, exponent);
    if (longer.find('.') == std::string::npos) longer += '.';
    longer += std::string(30, '0') + text.substr(exponent);
    const DecimalParse parse = parse_decimal(longer);
    ASSERT_EQ(parse.fault, DecimalFault::none) << text;
    const DecimalNumber expected = decimal_number(number.digits, -number.decimals);
    EXPECT_EQ(parse.number.digits, expected.digits) << text;
    EXPECT_EQ(parse.number.exponent, expected.exponent) << text;
    EXPECT_EQ(parse.number.nearest, std::strtod(text.c_str(), nullptr)) << text;
    EXPECT_EQ(parse_decimal(text).number.nearest, parse.number.nearest) << text;
    EXPECT_EQ(parse_decimal(text).number.exponent, parse.number.exponent) << text;
  }
}

}  // namespace
}  // namespace orthoball
