// SPDX-License-Identifier: MIT
//
// NumPy arrays (.npy, versions 1 to 3): a magic string, the length of a header, the header as the
// literal of a Python dictionary, the numbers. Read are arrays of two axes, points by columns, of
// floating-point numbers and integers.

#include <limits>
#include <optional>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/binary_rows.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"

namespace orthoball {
namespace {

using namespace std::string_view_literals;

struct Header {
  NumberType type = NumberType::float64;
  bool is_big_endian = false;
  bool is_fortran_order = false;
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t data = 0;  // where the numbers begin
};

// What follows `'key':` in the dictionary.
std::string_view value_of(const Source& source, std::string_view dictionary, std::string_view key) {
  std::string in_quotes(1, '\'');
  in_quotes.append(key).append(1, '\'');
  const std::size_t at = dictionary.find(in_quotes);
  const std::size_t colon = at == std::string_view::npos ? at : dictionary.find(':', at);
  if (colon == std::string_view::npos) {
    throw ParseError(source.name, 0, "byte 10: the header has no " + quoted(key));
  }
  return trimmed(dictionary.substr(colon + 1));
}

// A Python literal at the begin of `text`, as it is written: a string, a tuple or a list.
std::string_view literal(std::string_view text) {
  constexpr std::pair<char, char> kEnds[] = {{'\'', '\''}, {'(', ')'}, {'[', ']'}};
  for (const auto& [first, last] : kEnds) {
    if (text.empty() || text[0] != first) continue;
    const std::size_t end = text.find(last, 1);
    if (end != std::string_view::npos) return text.substr(0, end + 1);
  }
  return text.substr(0, text.find_first_of(",}\n"));
}

std::optional<NumberType> number_type(std::string_view letters) {
  constexpr std::pair<std::string_view, NumberType> kTypes[] = {
      {"f8", NumberType::float64}, {"f4", NumberType::float32}, {"i8", NumberType::int64},
      {"i4", NumberType::int32},   {"i2", NumberType::int16},   {"i1", NumberType::int8},
      {"u8", NumberType::uint64},  {"u4", NumberType::uint32},  {"u2", NumberType::uint16},
      {"u1", NumberType::uint8}};
  for (const auto& [name, type] : kTypes) {
    if (name == letters) return type;
  }
  return std::nullopt;
}

Header header_of(const Source& source) {
  const std::string_view bytes = source.bytes;
  const auto fail = [&](std::size_t offset, const std::string& message) {
    throw ParseError(source.name, 0, "byte " + std::to_string(offset) + ": " + message);
  };
  if (bytes.substr(0, 6) != "\x93NUMPY"sv)
    fail(0, "not a .npy file; it must begin with \\x93NUMPY");
  if (bytes.size() < 12) fail(bytes.size(), "the file ends within the header");
  const int version = static_cast<unsigned char>(bytes[6]);
  if (version < 1 || version > 3) {
    fail(6, "version " + std::to_string(version) + " of .npy; 1 to 3 are read");
  }
  const std::size_t length_size = version == 1 ? 2 : 4;
  const std::size_t length = unsigned_from_bytes(bytes.data() + 8, length_size);
  Header header;
  header.data = 8 + length_size + length;
  if (header.data > bytes.size()) fail(bytes.size(), "the file ends within the header");
  const std::string_view dictionary = bytes.substr(8 + length_size, length);

  const std::string_view type = literal(value_of(source, dictionary, "descr"));
  const bool is_plain = type.size() == 5 && type[0] == '\'' && type[4] == '\'';
  const auto known = is_plain ? number_type(type.substr(2, 2)) : std::nullopt;
  if (!known || "<>|="sv.find(type[1]) == std::string_view::npos) {
    fail(10, "elements of type " + printable(type) +
                 "; save the array as float64, float32 or integers");
  }
  header.type = *known;
  header.is_big_endian = type[1] == '>';
  header.is_fortran_order = value_of(source, dictionary, "fortran_order").substr(0, 4) == "True"sv;

  const std::string_view tuple = literal(value_of(source, dictionary, "shape"));
  const std::string_view shape = tuple.substr(0, tuple.find(')'));
  const std::size_t comma = shape.find(',');
  std::string_view second =
      comma == std::string_view::npos ? std::string_view() : trimmed(shape.substr(comma + 1));
  if (!second.empty() && second.back() == ',') second.remove_suffix(1);
  if (shape.empty() || shape[0] != '(' || second.empty() ||
      second.find(',') != std::string_view::npos) {
    fail(10, "an array of shape " + printable(tuple) +
                 "; points by columns, such as (1000, 3), are read");
  }
  header.rows = count_at(source, 0, trimmed(shape.substr(1, comma - 1)), "the number of rows");
  header.columns = count_at(source, 0, second, "the number of columns");
  return header;
}

}  // namespace

Reading read_npy(const Source& source, const ReadOptions& options) {
  const Header header = header_of(source);
  const std::size_t size = size_in_bytes(header.type);
  const std::size_t present = (source.bytes.size() - header.data) / size;
  const bool is_all_there =
      header.columns == 0 || header.rows == 0 || header.rows <= present / header.columns;
  if (!is_all_there || header.columns > present + kLargestInput) {
    throw ParseError(source.name, 0,
                     "byte " + std::to_string(source.bytes.size()) + ": " +
                         counted(header.rows, "row") + " of " + counted(header.columns, "number") +
                         " announced, fewer are there; the file is incomplete");
  }
  BinaryRows rows(
      source, chosen_columns(
                  source.name, options,
                  {.names = {}, .columns = header.columns, .numbers = header.columns, .line = 0}));
  rows.add_columns(header.rows, header.is_big_endian, [&](std::size_t column) {
    const std::size_t steps = header.is_fortran_order ? header.rows : 1;
    return BinaryColumn{.first = header.data + column * steps * size,
                        .stride = header.is_fortran_order ? size : header.columns * size,
                        .type = header.type};
  });
  return std::move(rows).reading();
}

}  // namespace orthoball
