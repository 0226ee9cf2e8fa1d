// SPDX-License-Identifier: MIT
#include "orthoball/input/source.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <system_error>
#include <utility>

#include "orthoball/error.h"

namespace orthoball {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kChunk = std::size_t{1} << 20U;
constexpr std::size_t kLargestRatio = 1032;  // that deflate can reach
constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max() / 2;

struct Signature {
  std::string_view bytes;
  std::string_view what;
};

constexpr std::array kCompressed = {
    Signature{"BZh"sv, "bzip2; run bunzip2 first"},
    Signature{"\x28\xb5\x2f\xfd"sv, "zstd; run unzstd first"},
    Signature{"\xfd"
              "7zXZ\0"sv,
              "xz; run unxz first"},
    Signature{"\x04\x22\x4d\x18"sv, "lz4; run unlz4 first"},
    Signature{"7z\xbc\xaf\x27\x1c"sv, "7z; run 7z x first"},
    Signature{"PK\3\4"sv, "zip; run unzip first"},
};

constexpr std::array kNotText = {
    Signature{"\x89PNG"sv, "a PNG picture"},
    Signature{"\xff\xd8\xff"sv, "a JPEG picture"},
    Signature{"GIF8"sv, "a GIF picture"},
    Signature{"%PDF-"sv, "a PDF document"},
    Signature{"\x89HDF"sv, "an HDF5 file"},
    Signature{"\x93NUMPY"sv, "a NumPy array (read it with the format npy)"},
    Signature{"LASF"sv, "a LAS point cloud (read it with the format las)"},
    Signature{"glTF"sv, "a binary glTF model"},
    Signature{"\x7f"
              "ELF"sv,
              "a program"},
    Signature{"\x1f\x8b"sv, "a gzip stream inside a gzip stream"},
};

bool has_bytes(std::string_view text, std::size_t at, std::string_view bytes) {
  return text.size() >= at && text.substr(at, bytes.size()) == bytes;
}

// Is it compressed in a way that is refused? "BZh" may begin a text: a block or an end must follow.
void refuse_compressed(const std::string& name, std::string_view bytes) {
  for (const Signature& signature : kCompressed) {
    if (!has_bytes(bytes, 0, signature.bytes)) continue;
    if (signature.bytes == "BZh" && !has_bytes(bytes, 4, "1AY&SY") &&
        !has_bytes(bytes, 4, "\x17\x72\x45\x38\x50\x90")) {
      continue;
    }
    throw ParseError(
        name, 0,
        "compressed with " + std::string(signature.what) + "; only gzip is decompressed here");
  }
}

[[noreturn]] void refuse_size(const std::string& name) {
  throw ParseError(
      name, 0, "larger than 1 GiB uncompressed; lift the limit with --no-limit if that is meant");
}

std::string all_bytes(const std::string& path, std::size_t limit, const MemoryBudget& memory) {
  const auto fail = [&](const char* what) {
    throw ParseError(path, 0,
                     std::string(what) + ": " + std::generic_category().message(errno) +
                         "; an existing, readable file is needed");
  };
  const auto close = [](std::FILE* file) {
    if (file != stdin) std::fclose(file);
  };
  errno = 0;
  const std::unique_ptr<std::FILE, decltype(close)> file(
      path == "-" ? stdin : std::fopen(path.c_str(), "rb"), close);
  if (!file) fail("cannot be opened");
  // What the file system says is a hint only: pipes say 0, and files grow.
  std::error_code no_size;
  const std::uintmax_t expected = std::filesystem::file_size(path, no_size);
  if (!no_size && expected <= limit) {
    memory.require(expected, path);
  }
  std::string bytes;
  std::size_t size = 0;
  std::size_t room =
      no_size ? kChunk : static_cast<std::size_t>(std::min<std::uintmax_t>(expected, limit)) + 1;
  for (;;) {
    if (size == bytes.size()) {
      bytes.resize(std::min(std::max(room, 2 * size), limit + 1));
      room = kChunk;
    }
    const std::size_t read = std::fread(bytes.data() + size, 1, bytes.size() - size, file.get());
    if (std::ferror(file.get()) != 0) fail("cannot be read");
    size += read;
    if (size > limit) refuse_size(path);
    if (read == 0) break;
  }
  bytes.resize(size);
  return bytes;
}

// All members of a gzip file, one after the other; zeros may follow the last one.
std::string gunzipped(const std::string& name, std::string_view packed, bool limited) {
  const std::size_t ratio_limit = std::max(kChunk, kLargestCompressionRatio * packed.size());
  const std::size_t limit = limited ? std::min(kLargestInput, ratio_limit) : kNoLimit;
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 16) != Z_OK) throw LimitError("out of memory in zlib");
  const std::unique_ptr<z_stream, decltype(&inflateEnd)> guard(&stream, &inflateEnd);

  // The last four bytes tell the size of the last member: of all, nearly always, or a lie.
  std::size_t expected = 0;
  for (std::size_t i = 1; i <= 4 && i <= packed.size(); ++i) {
    expected = expected << 8U | static_cast<unsigned char>(packed[packed.size() - i]);
  }
  std::string bytes;
  if (expected <= kLargestRatio * packed.size()) bytes.reserve(std::min(expected, limit) + 1);
  std::size_t size = 0;
  int status = Z_OK;
  do {
    if (size == bytes.size()) {
      const std::size_t room =
          std::max(kChunk, size + kChunk < bytes.capacity() ? size + kChunk : 2 * size);
      bytes.resize(std::min(room, limit + 1));
    }
    if (status == Z_STREAM_END) inflateReset(&stream);
    const auto input = static_cast<uInt>(std::min<std::size_t>(packed.size(), kLargestInput));
    const auto room = static_cast<uInt>(std::min(bytes.size() - size, kLargestInput));
    // zlib's interface lacks a const here; it does not write to its input.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = input;
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + size);
    stream.avail_out = room;
    status = inflate(&stream, Z_NO_FLUSH);
    packed.remove_prefix(input - stream.avail_in);
    size += room - stream.avail_out;
    if (size > limit) {
      if (limit == kLargestInput) refuse_size(name);
      throw ParseError(name, 0,
                       "expands to more than 200 times its size; lift the limit with --no-limit "
                       "if that is meant");
    }
    if (status == Z_BUF_ERROR || (status == Z_OK && packed.empty() && size < bytes.size())) {
      throw ParseError(name, 0, "the gzip stream ends early; the file is incomplete");
    }
    if (status != Z_OK && status != Z_STREAM_END) {
      throw ParseError(name, 0, "the gzip stream is corrupt; get the file anew");
    }
    if (status == Z_STREAM_END && packed.find_first_not_of('\0') == std::string_view::npos) break;
  } while (true);
  bytes.resize(size);
  return bytes;
}

std::size_t line_of(std::string_view text, std::size_t offset) {
  Lines lines(text.substr(0, offset + 1));
  std::string_view line;
  while (lines.next(line)) {
  }
  return lines.number();
}

}  // namespace

Source read_source(const std::string& path, bool limited, const MemoryBudget& memory) {
  Source source{path, all_bytes(path, limited ? kLargestInput : kNoLimit, memory)};
  refuse_compressed(path, source.bytes);
  if (has_bytes(source.bytes, 0, "\x1f\x8b")) {
    source.bytes = gunzipped(path, source.bytes, limited);
  }
  if (has_bytes(source.bytes, 0, "\xef\xbb\xbf")) source.bytes.erase(0, 3);
  return source;
}

void require_text(const Source& source) {
  const std::string_view text = source.bytes;
  const auto fail = [&](std::size_t line, const std::string& what) {
    throw ParseError(source.name, line, what);
  };
  for (const Signature& signature : kNotText) {
    if (has_bytes(text, 0, signature.bytes)) {
      fail(0, "looks like " + std::string(signature.what) + "; a text file is needed");
    }
  }
  const std::size_t nul = text.find('\0');
  const bool has_mark = has_bytes(text, 0, "\xff\xfe") || has_bytes(text, 0, "\xfe\xff");
  if (nul == std::string_view::npos && !has_mark) return;
  if (has_mark || (nul < 2 && text.size() > 3 && text[nul + 2] == '\0')) {
    fail(0, "looks like UTF-16 text; convert it with iconv -f UTF-16 -t UTF-8");
  }
  fail(line_of(text, nul), "a NUL byte: this is not a text file; a text file is needed");
}

bool Lines::next(std::string_view& line) {
  if (at_ >= text_.size()) return false;
  const auto find = [this](char c) { return std::min(text_.find(c, at_), text_.size()); };
  // Each search goes on where the last one of its kind ended, so a text is searched once.
  if (!is_searched_ || newline_ < at_) newline_ = find('\n');
  if (!is_searched_ || carriage_ < at_) carriage_ = find('\r');
  is_searched_ = true;
  const std::size_t end = std::min(newline_, carriage_);
  line = text_.substr(at_, end - at_);
  at_ = end + (end == carriage_ && newline_ == carriage_ + 1 ? 2 : 1);
  ++number_;
  return true;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kMost = 40;
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string words;
  for (const char c : text.substr(0, kMost)) {
    if (c >= ' ' && c <= '~') {
      words += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      words += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 15U]};
    }
  }
  return words + (text.size() > kMost ? "..." : "");
}

std::string quoted(std::string_view text) { return '"' + printable(text) + '"'; }

}  // namespace orthoball
