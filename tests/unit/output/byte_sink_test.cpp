// SPDX-License-Identifier: MIT
#include "orthoball/output/byte_sink.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>

namespace orthoball {
namespace {

template <class Write>
std::string written(const Write& write, std::string_view missing = "") {
  std::ostringstream out;
  ByteSink sink(out, missing);
  write(sink);
  sink.flush();
  return out.str();
}

TEST(ByteSink, RealsAreTheShortestTextThatReadsBack) {
  EXPECT_EQ(written([](ByteSink& s) { s.real(0.1); }), "0.1");
  EXPECT_EQ(written([](ByteSink& s) { s.real(1.0 / 3.0); }), "0.3333333333333333");
  EXPECT_EQ(written([](ByteSink& s) { s.real(1e300); }), "1e+300");
  EXPECT_EQ(written([](ByteSink& s) { s.real(2.0); }), "2");
  for (const double x : {5e-324, 1.7976931348623157e308, 123456789.12345679, -2.5e-7}) {
    EXPECT_EQ(std::strtod(shortest_text(x).c_str(), nullptr), x);
  }
}

TEST(ByteSink, ZeroHasNoSign) {
  EXPECT_EQ(written([](ByteSink& s) { s.real(-0.0); }), "0");
  EXPECT_EQ(shortest_text(-0.0), "0");
}

TEST(ByteSink, WritesTheMissingTextForNumbersThatAreNotFiniteAndCountsThem) {
  std::ostringstream out;
  ByteSink sink(out, "null");
  sink.real(std::numeric_limits<double>::infinity());
  sink.text(",");
  sink.real(std::numeric_limits<double>::quiet_NaN());
  sink.flush();
  EXPECT_EQ(out.str(), "null,null");
  EXPECT_EQ(sink.missing_count(), 2U);
}

TEST(ByteSink, EscapesQuotesAndControlCharactersInJson) {
  EXPECT_EQ(written([](ByteSink& s) { s.json_string("a\"b\\c\nd é"); }), R"("a\"b\\c\u000ad é")");
}

TEST(ByteSink, ReplacesWhatIsNotUtf8InJson) {
  const auto json = [](const std::string& text) {
    return written([&](ByteSink& s) { s.json_string(text); });
  };
  const std::string whole = "\"\xC3\xA9\xE2\x82\xAC\xED\x9F\xBF\xF0\x9F\x98\x80\xF4\x8F\xBF\xBF\"";
  EXPECT_EQ(json(whole.substr(1, whole.size() - 2)), whole);
  const std::string other = "\xEF\xBF\xBD";
  for (const char* const bad : {"\x80", "\xC1", "\xF5", "\xE9", "\xC3"}) {
    EXPECT_EQ(json(std::string("a") + bad + "b"), "\"a" + other + "b\"");
  }
  // Overlong, a surrogate, beyond the last character: every byte is replaced.
  for (const char* const bad : {"\xE0\x9F\xBF", "\xED\xA0\x80"}) {
    EXPECT_EQ(json(bad), "\"" + other + other + other + "\"");
  }
  for (const char* const bad : {"\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80"}) {
    EXPECT_EQ(json(bad), "\"" + other + other + other + other + "\"");
  }
}

TEST(ByteSink, KeepsTheOrderOfPiecesLargerThanItsBuffer) {
  const std::string large(3U << 20U, 'x');
  const std::string result = written([&](ByteSink& s) {
    s.text("a");
    s.text(large);
    s.integer(-7);
  });
  EXPECT_EQ(result, "a" + large + "-7");
}

TEST(ByteSink, WritesIntegersOfEveryLength) {
  for (const std::int64_t n :
       {std::int64_t{0}, std::int64_t{9}, std::int64_t{10}, std::int64_t{99}, std::int64_t{100},
        std::int64_t{-1}, std::int64_t{-10}, std::int64_t{4294967295},
        std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
    EXPECT_EQ(written([&](ByteSink& s) { s.integer(n); }), std::to_string(n));
  }
  for (std::int64_t n = 1; n < std::int64_t{1} << 60; n = 3 * n + 1) {
    EXPECT_EQ(written([&](ByteSink& s) { s.integer(n); }), std::to_string(n));
  }
}

TEST(ByteSink, LosesNothingWhereItsBufferEnds) {
  // Pieces of every kind that come to lie across the end of the buffer at every distance.
  for (const std::size_t before : {60U, 33U, 32U, 31U, 20U, 19U, 3U, 1U, 0U}) {
    const std::string filling((1U << 20U) - before, 'x');
    const std::string result = written([&](ByteSink& s) {
      s.text(filling);
      s.integer(-1234567890123456789);
      s.text("abc");
      s.real(-1.2345678901234568e-300);
      s.little_endian(std::uint64_t{0x3031323334353637});
      s.text(filling);
    });
    EXPECT_EQ(result,
              filling + "-1234567890123456789abc-1.2345678901234568e-30076543210" + filling);
  }
}

TEST(ByteSink, PutsTheLowestByteFirst) {
  EXPECT_EQ(written([](ByteSink& s) { s.little_endian(std::uint32_t{0x01020304}); }),
            "\x04\x03\x02\x01");
}

TEST(ByteSink, SaysThatAStreamCannotBeWritten) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  ByteSink sink(out);
  sink.text("x");
  EXPECT_THROW(sink.flush(), OutputError);
}

}  // namespace
}  // namespace orthoball
