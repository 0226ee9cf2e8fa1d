// SPDX-License-Identifier: MIT
#include "orthoball/output/encoded_output.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <sstream>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

std::string base64(const std::string& text, std::size_t piece) {
  return written([&](ByteSink& sink) {
    Base64Output out(sink);
    for (std::size_t i = 0; i < text.size(); i += piece) out << text.substr(i, piece);
    out.finish();
  });
}

std::string gzip(const std::string& bytes) {
  return written([&](ByteSink& sink) {
    GzipOutput out(sink);
    out << bytes;
    out.put('!');
    out.finish();
  });
}

std::string gunzipped(const std::string& bytes, std::size_t size) {
  std::string text(size, '\0');
  z_stream state{};
  EXPECT_EQ(inflateInit2(&state, 16 + 15), Z_OK);
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  state.avail_in = static_cast<uInt>(bytes.size());
  state.next_out = reinterpret_cast<Bytef*>(text.data());
  state.avail_out = static_cast<uInt>(text.size());
  EXPECT_EQ(inflate(&state, Z_FINISH), Z_STREAM_END);
  EXPECT_EQ(state.avail_in, 0U);
  text.resize(text.size() - state.avail_out);
  inflateEnd(&state);
  return text;
}

TEST(Base64Output, GivesTheExamplesOfTheStandardInWhateverPieces) {
  for (const std::size_t piece : {1U, 2U, 3U, 6U}) {
    EXPECT_EQ(base64("", piece), "");
    EXPECT_EQ(base64("f", piece), "Zg==");
    EXPECT_EQ(base64("fo", piece), "Zm8=");
    EXPECT_EQ(base64("foo", piece), "Zm9v");
    EXPECT_EQ(base64("foob", piece), "Zm9vYg==");
    EXPECT_EQ(base64("fooba", piece), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar", piece), "Zm9vYmFy");
  }
  EXPECT_EQ(base64("\xFF\xFE\xFD", 3), "//79");
}

TEST(Base64Output, PutsSomethingBetweenPartsOfWholeGroups) {
  const std::string text = written([](ByteSink& sink) {
    Base64Output out(sink, "|", 6);
    for (const char c : std::string("foobarfoobarf")) out.put(c);
    out.finish();
  });
  EXPECT_EQ(text, "Zm9vYmFy|Zm9vYmFy|Zg==");
  EXPECT_EQ(written([](ByteSink& sink) { Base64Output(sink, "|", 6).finish(); }), "");
}

TEST(GzipOutput, IsReadBackByZlib) {
  std::string bytes;
  for (int i = 0; i < 300000; ++i) bytes += static_cast<char>(i * i >> 7);
  EXPECT_EQ(gunzipped(gzip(bytes), bytes.size() + 1), bytes + "!");
  EXPECT_EQ(gzip(bytes), gzip(bytes));
  EXPECT_EQ(gunzipped(gzip(""), 1), "!");
}

TEST(GzipOutput, PassesOnThatNothingCanBeWritten) {
  std::ostringstream broken;
  broken.setstate(std::ios::badbit);
  ByteSink sink(broken);
  GzipOutput out(sink);
  std::string noise;
  std::uint32_t state = 1;
  for (int i = 0; i < 3000000; ++i) {
    state = state * 1664525U + 1013904223U;
    noise += static_cast<char>(state >> 24U);
  }
  EXPECT_THROW(out << noise << noise, OutputError);
}

}  // namespace
}  // namespace orthoball
