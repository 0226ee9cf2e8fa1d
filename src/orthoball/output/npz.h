// SPDX-License-Identifier: MIT
#pragma once

#include <array>
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
  /// A column of a table, one number of type T a row, as `of` gives it.
  template <class T, class Rows, class Of>
  void add_column(std::string_view name, const Rows& rows, const Of& of) {
    std::vector<T> values;
    values.reserve(rows.size());
    for (const auto& row : rows) values.push_back(of(row));
    add<T>(name, std::array{values.size()}, values);
  }
  /// Several columns of counts in one array: `width` numbers a row, as `of` gives them.
  template <class Rows, class Of>
  void add_columns(std::string_view name, std::size_t width, const Rows& rows, const Of& of) {
    std::vector<std::uint32_t> values;
    values.reserve(rows.size() * width);
    for (const auto& row : rows) {
      const std::span<const std::uint32_t> numbers = of(row);
      values.insert(values.end(), numbers.begin(), numbers.end());
    }
    add<std::uint32_t>(name, std::array{rows.size(), width}, values);
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
