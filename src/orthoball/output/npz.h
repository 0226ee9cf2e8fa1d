// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/output/byte_sink.h"

namespace orthoball {

/// An archive of arrays as NumPy's `load` reads it: an uncompressed zip of .npy files, with the
/// 64-bit extensions where they are needed. Names, order and bytes alone decide the bytes written.
class NpzWriter {
 public:
  explicit NpzWriter(ByteSink& sink) : sink_(sink) {}

  /// One array in C order.
  /// @param name    without .npy.
  /// @param shape   its product is the number of values.
  /// @throws OutputError
  template <class T>
  void add(std::string_view name, std::span<const std::size_t> shape, std::span<const T> values) {
    static_assert(std::endian::native == std::endian::little);
    add_bytes(name, type_text(T{}), shape,
              {reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  }
  /// Writes the archive's directory and flushes the sink.
  void finish();

 private:
  struct Entry {
    std::string name;
    std::uint32_t checksum;
    std::uint64_t size;
    std::uint64_t offset;
  };
  static std::string_view type_text(double) { return "<f8"; }
  static std::string_view type_text(std::uint32_t) { return "<u4"; }
  static std::string_view type_text(std::int64_t) { return "<i8"; }
  static std::string_view type_text(std::uint8_t) { return "|u1"; }
  void add_bytes(std::string_view name, std::string_view type, std::span<const std::size_t> shape,
                 std::string_view bytes);

  ByteSink& sink_;
  std::vector<Entry> entries_;
  std::uint64_t offset_ = 0;
};

}  // namespace orthoball
