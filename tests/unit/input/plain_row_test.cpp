// SPDX-License-Identifier: MIT
#include "orthoball/input/plain_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "generators/random.h"
#include "unit/input/inline_source.h"

// Rows that are read in one pass must give what rows read field by field give: the same numbers in
// the same units, the same lines, the same complaints. Quotes around a field make the difference.

namespace orthoball {
namespace {

// Everything a reading says, or the error.
std::string description_of(const std::string& text, const ReadOptions& options = {}) {
  try {
    const Reading reading = read_table({"f", text}, options);
    std::string words = std::to_string(reading.points.decimals().value_or(-1));
    const auto add = [&](auto numbers) {
      for (const auto number : numbers) {
        words += ' ';
        words += std::to_string(number);
        if (std::signbit(static_cast<double>(number)) && number == 0) words += "negative zero";
      }
      words += ';';
    };
    add(reading.points.coordinates());
    add(reading.points.weights());
    add(reading.points.weights_low());
    add(std::span(reading.labels.line));
    return words;
  } catch (const ParseError& error) {
    return error.what();
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string pick(generators::Random& random, const std::vector<std::string>& words) {
  return words[static_cast<std::size_t>(random.integer(0, static_cast<int>(words.size()) - 1))];
}

// How often each is picked decides how long the plain runs are.
struct Words {
  std::vector<std::string> numbers, others, line_ends, comments;
  double odd;  // share of numbers that are from `others`
};

// The same table twice: as it is, and with quotes that forbid the single pass.
std::pair<std::string, std::string> tables(generators::Random& random, const Words& words,
                                           const std::string& separator, int columns) {
  std::string plain, quoted;
  for (int row = 0; row < 12; ++row) {
    if (row > 0 && random.uniform() < 0.1) {
      const std::string comment = pick(random, words.comments);
      plain += comment;
      quoted += comment;
    }
    const int here = columns + (random.uniform() < 0.01 ? 1 : 0);
    for (int column = 0; column < here; ++column) {
      const bool is_odd = row > 0 && random.uniform() < words.odd;
      const std::string field = pick(random, is_odd ? words.others : words.numbers);
      const std::string before = column == 0 ? "" : separator;
      plain += before + field;
      quoted += before + '"' + field + '"';
    }
    const std::string end = pick(random, words.line_ends);
    plain += end;
    quoted += end;
  }
  return {plain, quoted};
}

TEST(PlainRows, AreReadAsFieldByField) {
  generators::Random random(5);
  const std::vector<std::string> ends{"\n", "\n", "\n", "\r\n", "\r"};
  const std::vector<std::string> comments{"\n", "# no row\n", "  \n", "%x\n", "// y\r\n"};
  const std::vector<Words> kinds{
      {{"1", "0.5", "-2.25", "100", "0.000", "-0", "12.5000"},
       {"1e1", "2.5e-3", "3.123456", "+7", "1d1", "5.", ".5", "1234567890.5"},
       ends,
       comments,
       0.1},
      {{"0.1", "0.25", "17"},
       {"0.12345678901234567", "1e300", "9007199254740993", "-0.0", "1e-320", "5e-400"},
       ends,
       comments,
       0.02},
      {{"1", "2", "3.5"},
       {"nan", "1e999", "x", "1.5x", "--1", "0x10", "inf", "+-1"},
       ends,
       comments,
       0.01},
  };
  for (int i = 0; i < 30'000; ++i) {
    const Words& words = kinds[static_cast<std::size_t>(random.integer(0, 2))];
    const std::string separator = pick(random, {",", " ", "  ", "\t", " ,", ", ", " \t"});
    const int columns = random.integer(2, 5);
    ReadOptions options;
    if (columns > 3 && random.coin()) options.radius_column = "4";
    if (columns > 3 && options.radius_column.empty() && random.coin()) options.weight_column = "3";
    if (columns == 5 && random.coin()) options.columns = {"5", "2"};
    if (columns == 5 && random.uniform() < 0.1) options.columns = {"4", "4", "1"};
    const auto [plain, quoted] = tables(random, words, separator, columns);
    ASSERT_EQ(description_of(plain, options), description_of(quoted, options))
        << plain << "\nfor separator \"" << separator << '"';
  }
}

TEST(PlainRows, UnusedColumnsMayHoldAnything) {
  const std::string names = "name,x,y,remark\n";
  EXPECT_EQ(
      description_of(names + "a,1,2,b c\nd e f,3,4,\n,5,6,\"x,y\"\n\xC3\xA4,7,8,#\n"),
      "0 1.000000 2.000000 3.000000 4.000000 5.000000 6.000000 7.000000 8.000000;;; 2 3 4 5;");
  EXPECT_EQ(
      description_of("x y name\n1 2 a\n3 4 b\n5 6 %\n7 8 /\n"),
      "0 1.000000 2.000000 3.000000 4.000000 5.000000 6.000000 7.000000 8.000000;;; 2 3 4 5;");
  // A comment mark in the first column is a comment, even where that column is not used.
  EXPECT_EQ(description_of("name,x,y\na,1,2\nb,3,4\n%c,5,6\n//d,7,8\n/e,7,8\n"),
            "0 1.000000 2.000000 3.000000 4.000000 7.000000 8.000000;;; 2 3 6;");
}

TEST(PlainRows, FieldsThatTouchAreNoRows) {
  EXPECT_EQ(description_of("1 2\n3 4\n5-6\n"), "f:3: 1 column, expected 2 as on line 1");
  EXPECT_NE(description_of("1 2 3\n1 2 3\n1 2-3 4\n").find("f:3: column 2 is"), std::string::npos);
}

}  // namespace
}  // namespace orthoball
