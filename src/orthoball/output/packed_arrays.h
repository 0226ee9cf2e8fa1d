// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "orthoball/output/byte_sink.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// How the numbers of a packed array are kept.
enum class PackedType {
  u32,  ///< whole numbers of 32 bits
  f64,  ///< doubles, exact
  f32,  ///< doubles, rounded to 24 bits
};

/// A file of named arrays behind a header in JSON, packed so that gzip does well: the container of
/// a snapshot, docs/file_formats/snapshot.md. The bytes follow from names, order and numbers alone.
///
/// An array is made when it is written, so that at most one of them is in memory.
class PackedArrays {
 public:
  using Numbers = RawVector<std::uint32_t>;  ///< what is kept as u32
  using Reals = RawVector<double>;           ///< what is kept as f64 or f32

  /// Whole numbers.
  /// @param length  of what `numbers` returns.
  /// @param stride  each number is kept as its difference from that so many places before; 0 for
  ///                the numbers themselves.
  void add(std::string name, std::size_t length, std::size_t stride,
           std::function<Numbers()> numbers);
  /// Doubles.
  /// @param type  f64 or f32.
  void add(std::string name, std::size_t length, PackedType type, std::function<Reals()> reals);

  /// Writes everything and flushes the sink.
  /// @param facts  members of the header before its list of arrays: `"key":value,...`.
  /// @throws OutputError
  void write(ByteSink& sink, std::string_view facts) const;

 private:
  struct Array {
    std::string name;
    PackedType type;
    std::size_t length;
    std::size_t stride;
    std::variant<std::function<Numbers()>, std::function<Reals()>> made_by;

    [[nodiscard]] std::size_t size() const { return length * (type == PackedType::f64 ? 8 : 4); }
  };

  [[nodiscard]] std::string header(std::string_view facts) const;

  std::vector<Array> arrays_;
};

}  // namespace orthoball
