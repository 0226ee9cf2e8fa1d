// SPDX-License-Identifier: MIT
#include "orthoball/input/source.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "orthoball/error.h"

namespace orthoball {
namespace {

using namespace std::string_literals;

// A file that lives as long as this.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& bytes)
      : path_(testing::TempDir() + "orthoball_source_test") {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(compressBound(bytes.size()) + 64, '\0');
  std::string input = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string bytes_of(const std::string& bytes, bool limited = true) {
  const TemporaryFile file(bytes);
  return read_source(file.path(), limited).bytes;
}

std::string error_of(const std::string& bytes) {
  const TemporaryFile file(bytes);
  try {
    require_text(read_source(file.path(), true));
  } catch (const ParseError& error) {
    return std::string(error.what()).substr(file.path().size());
  }
  return {};
}

TEST(ReadSource, GivesTheBytesWithoutAByteOrderMark) {
  EXPECT_EQ(bytes_of(""), "");
  EXPECT_EQ(bytes_of("a\nb"), "a\nb");
  EXPECT_EQ(bytes_of("\xef\xbb\xbf"
                     "a"),
            "a");
  const std::string large(3000000, 'x');
  EXPECT_EQ(bytes_of(large), large);
}

TEST(ReadSource, UnpacksEveryMemberOfAGzipFile) {
  const std::string text(2500000, 'y');
  EXPECT_EQ(bytes_of(gzipped("1 2 3\n") + gzipped("4 5 6\n")), "1 2 3\n4 5 6\n");
  EXPECT_EQ(bytes_of(gzipped("1 2 3\n") + std::string(512, '\0')), "1 2 3\n");
  EXPECT_EQ(bytes_of(gzipped("")), "");
  EXPECT_EQ(bytes_of(gzipped(text), false), text);
  // The size that the last member tells is not that of all.
  EXPECT_EQ(bytes_of(gzipped(text) + gzipped("z") + gzipped(text) + gzipped(""), false),
            text + "z" + text);
}

TEST(ReadSource, RefusesGzipThatIsCutOrCorrupt) {
  const std::string packed = gzipped("0.25 1.5 2\n0.5 1 7\n");
  for (std::size_t length = 2; length < packed.size(); ++length) {
    EXPECT_NE(error_of(packed.substr(0, length)).find("ends early"), std::string::npos) << length;
  }
  EXPECT_NE(error_of("\x1f\x8b\x08\0garbagegarbagegarbage"s).find("corrupt"), std::string::npos);
  EXPECT_NE(error_of(packed + "tail").find("corrupt"), std::string::npos);
  std::string wrong_sum = packed;
  wrong_sum[wrong_sum.size() - 6] ^= 1;
  EXPECT_NE(error_of(wrong_sum).find("corrupt"), std::string::npos);
}

TEST(ReadSource, StopsAtTheCompressionRatio) {
  const std::string bomb = gzipped(std::string(20000000, '0'));
  EXPECT_NE(error_of(bomb).find("200 times"), std::string::npos);
  EXPECT_EQ(bytes_of(bomb, false).size(), 20000000U);
  EXPECT_EQ(bytes_of(gzipped(std::string(1000000, '0'))).size(), 1000000U);
}

TEST(ReadSource, RefusesOtherCompressionsByName) {
  EXPECT_NE(error_of("BZh91AY&SY....").find("bzip2"), std::string::npos);
  EXPECT_EQ(error_of("BZh9 is a text\n"), "");
  EXPECT_NE(error_of("\x28\xb5\x2f\xfd....").find("zstd"), std::string::npos);
  EXPECT_NE(error_of("\xfd"
                     "7zXZ\0...."s)
                .find("xz"),
            std::string::npos);
  EXPECT_NE(error_of("PK\3\4....").find("zip"), std::string::npos);
}

TEST(ReadSource, SaysWhyAFileCannotBeRead) {
  EXPECT_THROW(static_cast<void>(read_source("/nonexistent/file", true)), ParseError);
  EXPECT_THROW(static_cast<void>(read_source("/", true)), ParseError);
}

TEST(RequireText, NamesWhatIsNoText) {
  EXPECT_EQ(error_of("ATOM\n"), "");
  EXPECT_NE(error_of("\x89PNG\r\n").find("PNG"), std::string::npos);
  EXPECT_NE(error_of("A\0T\0O\0M\0"s).find("UTF-16"), std::string::npos);
  EXPECT_NE(error_of("\xff\xfe"s + "A\0"s).find("UTF-16"), std::string::npos);
  EXPECT_EQ(error_of("first\nsec\0ond\n"s).substr(0, 3), ":2:");
  EXPECT_EQ(error_of("\rtwo\r\nthree\nfo\0ur"s).substr(0, 3), ":4:");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> all;
  Lines lines(text);
  std::string_view line;
  while (lines.next(line)) {
    all.emplace_back(line);
    EXPECT_EQ(lines.number(), all.size());
  }
  return all;
}

TEST(Lines, EndAtEveryKindOfLineEnd) {
  using List = std::vector<std::string>;
  EXPECT_EQ(lines_of(""), List{});
  EXPECT_EQ(lines_of("a"), List{"a"});
  EXPECT_EQ(lines_of("a\nb\n"), (List{"a", "b"}));
  EXPECT_EQ(lines_of("a\r\nb\rc\n\rd"), (List{"a", "b", "c", "", "d"}));
  EXPECT_EQ(lines_of("\n\n"), (List{"", ""}));
}

TEST(Lines, AreFoundInLinearTime) {
  EXPECT_EQ(lines_of(std::string(1000000, '\r')).size(), 1000000U);
}

TEST(Lines, TellWhatFollows) {
  Lines lines("a\r\nbc");
  std::string_view line;
  EXPECT_TRUE(lines.next(line));
  EXPECT_EQ(lines.rest(), "bc");
  EXPECT_TRUE(lines.next(line));
  EXPECT_EQ(lines.rest(), "");
}

TEST(Quoted, PrintsNoRawBytes) {
  EXPECT_EQ(orthoball::quoted("12.3x4"), "\"12.3x4\"");
  EXPECT_EQ(orthoball::quoted("\x1b[1m\xc3"), "\"\\x1b[1m\\xc3\"");
  EXPECT_EQ(orthoball::quoted(std::string(50, 'a')), "\"" + std::string(40, 'a') + "...\"");
}

}  // namespace
}  // namespace orthoball
