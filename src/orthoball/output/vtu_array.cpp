// SPDX-License-Identifier: MIT
#include "orthoball/output/vtu_array.h"

#include <cstdint>

namespace orthoball {
namespace {

void write_base64(ByteSink& sink, std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
  };
  // In pieces that the sink does not see, so that nothing is read again after each digit.
  std::array<char, 4096> piece;
  std::size_t size = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    piece[size] = kDigits[three >> 18U];
    piece[size + 1] = kDigits[three >> 12U & 63U];
    piece[size + 2] = i + 1 < bytes.size() ? kDigits[three >> 6U & 63U] : '=';
    piece[size + 3] = i + 2 < bytes.size() ? kDigits[three & 63U] : '=';
    size += 4;
    if (size < piece.size()) continue;
    sink.text({piece.data(), size});
    size = 0;
  }
  sink.text({piece.data(), size});
}

}  // namespace

void write_vtu_piece(ByteSink& sink, std::size_t points, std::size_t cells) {
  sink.text("<Piece NumberOfPoints=\"");
  sink.integer(static_cast<std::int64_t>(points));
  sink.text("\" NumberOfCells=\"");
  sink.integer(static_cast<std::int64_t>(cells));
  sink.text("\">\n");
}

void VtuArray::write(ByteSink& sink, std::string_view attributes) const {
  sink.text("<DataArray ");
  sink.text(attributes);
  sink.text(" format=\"binary\">");
  VtuArray size;
  size.add(static_cast<std::uint64_t>(bytes_.size()));
  write_base64(sink, size.bytes_);
  write_base64(sink, bytes_);
  sink.text("</DataArray>\n");
}

}  // namespace orthoball
