// SPDX-License-Identifier: MIT
//
// The zip format: for every file a local header and its bytes, then the directory with one entry a
// file, then the end record. Sizes and offsets that do not fit 32 bits are written as 2^32 - 1 with
// the number in an extra field, and a second end record precedes the first. We always know sizes
// and checksums before a file is written, so nothing is patched and any stream will do.

#include "orthoball/output/npz.h"

#include <zlib.h>

#include <algorithm>

namespace orthoball {
namespace {

constexpr std::uint32_t kLocalHeader = 0x04034b50, kDirectoryEntry = 0x02014b50, kEnd = 0x06054b50,
                        kEnd64 = 0x06064b50, kEnd64Locator = 0x07064b50;
constexpr std::uint64_t kFull = 0xFFFFFFFFU;
constexpr std::uint16_t kDate = (0U << 9U) | (1U << 5U) | 1U;  // 1980-01-01, the earliest

std::uint32_t low(std::uint64_t number) {
  return static_cast<std::uint32_t>(std::min(number, kFull));
}

std::uint32_t checksum(std::string_view header, std::string_view bytes) {
  uLong crc = crc32_z(0, nullptr, 0);
  crc = crc32_z(crc, reinterpret_cast<const Bytef*>(header.data()), header.size());
  // An empty array may have no address, and for none zlib begins anew.
  if (!bytes.empty()) {
    crc = crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  }
  return static_cast<std::uint32_t>(crc);
}

// The header of a .npy file, padded so that the data begins at a multiple of 64.
std::string npy_header(std::string_view type, std::span<const std::size_t> shape) {
  std::string text = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (";
  for (const std::size_t n : shape) text += std::to_string(n) + ",";
  text += "), }";
  text.resize((10 + text.size() + 1 + 63) / 64 * 64 - 10 - 1, ' ');
  text += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(text.size() & 0xFFU);
  header += static_cast<char>(text.size() >> 8U);
  return header + text;
}

}  // namespace

void NpzWriter::add_bytes(std::string_view name, std::string_view type,
                          std::span<const std::size_t> shape, std::string_view bytes) {
  const std::string header = npy_header(type, shape);
  const Entry entry{std::string(name) + ".npy", checksum(header, bytes),
                    header.size() + bytes.size(), offset_};
  const bool is_large = entry.size >= kFull;
  sink_.little_endian(kLocalHeader);
  sink_.little_endian(std::uint16_t{45});  // version needed
  sink_.little_endian(std::uint16_t{0});   // flags
  sink_.little_endian(std::uint16_t{0});   // stored
  sink_.little_endian(std::uint16_t{0});   // time
  sink_.little_endian(kDate);
  sink_.little_endian(entry.checksum);
  sink_.little_endian(is_large ? low(kFull) : low(entry.size));
  sink_.little_endian(is_large ? low(kFull) : low(entry.size));
  sink_.little_endian(static_cast<std::uint16_t>(entry.name.size()));
  sink_.little_endian(static_cast<std::uint16_t>(is_large ? 20 : 0));
  sink_.text(entry.name);
  if (is_large) {
    sink_.little_endian(std::uint16_t{1});
    sink_.little_endian(std::uint16_t{16});
    sink_.little_endian(entry.size);
    sink_.little_endian(entry.size);
  }
  sink_.text(header);
  sink_.text(bytes);
  offset_ += 30 + entry.name.size() + (is_large ? 20 : 0) + entry.size;
  entries_.push_back(entry);
}

void NpzWriter::finish() {
  const std::uint64_t start = offset_;
  for (const Entry& entry : entries_) {
    const bool is_large = entry.size >= kFull || entry.offset >= kFull;
    sink_.little_endian(kDirectoryEntry);
    sink_.little_endian(std::uint16_t{45});  // version made by
    sink_.little_endian(std::uint16_t{45});
    sink_.little_endian(std::uint16_t{0});
    sink_.little_endian(std::uint16_t{0});
    sink_.little_endian(std::uint16_t{0});
    sink_.little_endian(kDate);
    sink_.little_endian(entry.checksum);
    sink_.little_endian(is_large ? low(kFull) : low(entry.size));
    sink_.little_endian(is_large ? low(kFull) : low(entry.size));
    sink_.little_endian(static_cast<std::uint16_t>(entry.name.size()));
    sink_.little_endian(static_cast<std::uint16_t>(is_large ? 28 : 0));
    sink_.little_endian(std::uint16_t{0});  // no comment
    sink_.little_endian(std::uint16_t{0});  // disk
    sink_.little_endian(std::uint16_t{0});  // attributes
    sink_.little_endian(std::uint32_t{0});
    sink_.little_endian(is_large ? low(kFull) : low(entry.offset));
    sink_.text(entry.name);
    if (is_large) {
      sink_.little_endian(std::uint16_t{1});
      sink_.little_endian(std::uint16_t{24});
      sink_.little_endian(entry.size);
      sink_.little_endian(entry.size);
      sink_.little_endian(entry.offset);
    }
    offset_ += 46 + entry.name.size() + (is_large ? 28 : 0);
  }
  const std::uint64_t size = offset_ - start;
  const auto count = static_cast<std::uint16_t>(entries_.size());
  if (start >= kFull) {
    sink_.little_endian(kEnd64);
    sink_.little_endian(std::uint64_t{44});
    sink_.little_endian(std::uint16_t{45});
    sink_.little_endian(std::uint16_t{45});
    sink_.little_endian(std::uint32_t{0});
    sink_.little_endian(std::uint32_t{0});
    sink_.little_endian(std::uint64_t{count});
    sink_.little_endian(std::uint64_t{count});
    sink_.little_endian(size);
    sink_.little_endian(start);
    sink_.little_endian(kEnd64Locator);
    sink_.little_endian(std::uint32_t{0});
    sink_.little_endian(offset_);
    sink_.little_endian(std::uint32_t{1});
  }
  sink_.little_endian(kEnd);
  sink_.little_endian(std::uint16_t{0});
  sink_.little_endian(std::uint16_t{0});
  sink_.little_endian(count);
  sink_.little_endian(count);
  sink_.little_endian(low(size));
  sink_.little_endian(low(start));
  sink_.little_endian(std::uint16_t{0});
  sink_.flush();
}

}  // namespace orthoball
