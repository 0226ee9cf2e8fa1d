// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "orthoball/output/byte_sink.h"

namespace orthoball {

/// What stands before and after the one piece of a VTU file.
inline constexpr std::string_view kVtuHead =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
inline constexpr std::string_view kVtuTail = "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

/// The beginning of the piece. @throws OutputError
void write_vtu_piece(ByteSink& sink, std::size_t points, std::size_t cells);

/// One array of a VTU file: collects numbers, lowest byte first, then writes them as a DataArray in
/// base64, the number of bytes encoded by itself, then the bytes.
class VtuArray {
 public:
  /// At the end.
  template <class T>
  void add(T number) {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &number, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    bytes_.append(bytes.data(), bytes.size());
  }
  /// @param attributes  of the element: `type="Float64" Name="points"`. @throws OutputError
  void write(ByteSink& sink, std::string_view attributes) const;

 private:
  std::string bytes_;
};

}  // namespace orthoball
