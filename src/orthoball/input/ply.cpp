// SPDX-License-Identifier: MIT
//
// PLY polygon files, ASCII and binary in both byte orders: a header declares elements and their
// properties, the elements follow in that order. The points are the element `vertex`; its scalar
// properties are the columns, its lists and the elements before it are stepped over.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/binary_rows.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/text_rows.h"

namespace orthoball {
namespace {

struct Property {
  std::string name;
  NumberType type = NumberType::float32;
  bool is_list = false;
  NumberType count_type = NumberType::uint8;  // of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { ascii, little_endian, big_endian };

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> before;  // the elements before the vertices
  Element vertex;
  std::vector<std::string> names;  // of the scalar properties of a vertex
  Lines body{std::string_view()};  // has returned the last line of the header
};

std::optional<NumberType> number_type(std::string_view name) {
  constexpr std::pair<std::string_view, NumberType> kTypes[] = {
      {"char", NumberType::int8},      {"int8", NumberType::int8},
      {"uchar", NumberType::uint8},    {"uint8", NumberType::uint8},
      {"short", NumberType::int16},    {"int16", NumberType::int16},
      {"ushort", NumberType::uint16},  {"uint16", NumberType::uint16},
      {"int", NumberType::int32},      {"int32", NumberType::int32},
      {"uint", NumberType::uint32},    {"uint32", NumberType::uint32},
      {"float", NumberType::float32},  {"float32", NumberType::float32},
      {"double", NumberType::float64}, {"float64", NumberType::float64}};
  for (const auto& [word, type] : kTypes) {
    if (word == name) return type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  explicit HeaderReader(const Source& source) : source_(source), lines_(source.bytes) {}

  Header header() {
    if (!next_line() || line_ != "ply") fail("not a PLY file; its first line must be ply");
    std::vector<Element> elements;
    std::optional<Encoding> encoding;
    for (;;) {
      if (!next_line()) fail("the header ends early; end_header is missing");
      if (line_ == "end_header") break;
      if (fields_.empty() || fields_[0] == "comment" || fields_[0] == "obj_info") continue;
      if (fields_[0] == "format") {
        encoding = encoding_named();
      } else if (fields_[0] == "element" && fields_.size() == 3) {
        elements.push_back({std::string(fields_[1]),
                            count_at(source_, lines_.number(), fields_[2], "the element count"),
                            {}});
      } else if (fields_[0] == "property" && !elements.empty()) {
        elements.back().properties.push_back(property());
      } else {
        fail(quoted(line_) + " is no line of a PLY header");
      }
    }
    if (!encoding) fail("the header names no format; ascii or a binary one is needed");
    const auto vertex = std::find_if(elements.begin(), elements.end(),
                                     [](const Element& e) { return e.name == "vertex"; });
    if (vertex == elements.end()) fail("there is no element vertex; the points are its elements");
    Header header{
        .encoding = *encoding, .before = {}, .vertex = *vertex, .names = {}, .body = lines_};
    header.before.assign(elements.begin(), vertex);
    for (const Property& property : header.vertex.properties) {
      if (!property.is_list) header.names.push_back(property.name);
    }
    const auto has = [&](const char* name) {
      return std::find(header.names.begin(), header.names.end(), name) != header.names.end();
    };
    has_xy_ = has("x") && has("y");
    return header;
  }
  [[nodiscard]] bool has_xy() const { return has_xy_; }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw ParseError(source_.name, lines_.number(), message);
  }
  bool next_line() {
    if (!lines_.next(line_)) return false;
    line_ = trimmed(line_);
    split_at_blanks(line_, fields_);
    return true;
  }
  [[nodiscard]] Encoding encoding_named() const {
    const std::string_view name = fields_.size() > 1 ? fields_[1] : std::string_view();
    if (name == "ascii") return Encoding::ascii;
    if (name == "binary_little_endian") return Encoding::little_endian;
    if (name == "binary_big_endian") return Encoding::big_endian;
    fail("format " + quoted(name) + "; ascii and the two binary ones are read");
  }
  [[nodiscard]] Property property() const {
    const bool is_list = fields_.size() == 5 && fields_[1] == "list";
    if (!is_list && fields_.size() != 3) fail("a property needs a type and a name");
    const auto type = number_type(fields_[is_list ? 3 : 1]);
    const auto count_type = is_list ? number_type(fields_[2]) : NumberType::uint8;
    if (!type || !count_type) fail("a property of unknown type: " + quoted(line_));
    return {std::string(fields_.back()), *type, is_list, *count_type};
  }

  const Source& source_;
  Lines lines_;
  std::string_view line_;
  std::vector<std::string_view> fields_;
  bool has_xy_ = false;
};

// The number of items in a list; empty if `count` is none.
std::optional<std::size_t> list_size(double count) {
  if (!(count >= 0.0) || count > 4294967295.0 || count != std::trunc(count)) return std::nullopt;
  return static_cast<std::size_t>(count);
}

Reading read_ascii(const Source& source, const ReadOptions& options, Header header) {
  TextRows sites(source, options);
  std::vector<std::string_view> fields, scalars;
  const auto next_line = [&](const Element& element, std::size_t row) {
    std::string_view line;
    do {
      if (!header.body.next(line)) {
        throw ParseError(source.name, header.body.number(),
                         std::to_string(element.count) + " elements " + quoted(element.name) +
                             " announced, " + std::to_string(row) + " found; the two must agree");
      }
      split_at_blanks(line, fields);
    } while (fields.empty());
  };
  for (const Element& element : header.before) {
    for (std::size_t row = 0; row < element.count; ++row) next_line(element, row);
  }
  const bool has_list = header.names.size() != header.vertex.properties.size();
  for (std::size_t row = 0; row < header.vertex.count; ++row) {
    next_line(header.vertex, row);
    const std::size_t line = header.body.number();
    if (row == 0) sites.name_columns(line, header.names);
    scalars.clear();
    std::size_t at = 0;
    for (const Property& property : header.vertex.properties) {
      if (at >= fields.size()) break;
      if (property.is_list) {
        const auto items = list_size(parse_decimal(fields[at]).number.nearest);
        at += 1 + items.value_or(fields.size());
      } else {
        scalars.push_back(fields[at++]);
      }
    }
    if (at != fields.size() || scalars.size() != header.names.size()) {
      throw ParseError(source.name, line,
                       "a line of " + counted(fields.size(), "number") +
                           ", which is not the vertex that the header declares; each vertex needs "
                           "a line with all its properties");
    }
    sites.add(line, scalars);
    if (!has_list) row += sites.add_plain(header.body, {.most = header.vertex.count - row - 1});
  }
  return std::move(sites).reading();
}

class BinaryBody {
 public:
  BinaryBody(const Source& source, const Header& header)
      : source_(source),
        at_(source.bytes.size() - header.body.rest().size()),
        is_big_endian_(header.encoding == Encoding::big_endian) {}

  void skip(const Element& element) {
    std::size_t size = 0;
    bool has_list = false;
    for (const Property& property : element.properties) {
      size += size_in_bytes(property.type);
      has_list = has_list || property.is_list;
    }
    if (!has_list) {
      step(size == 0 ? 0 : element.count, size);
      return;
    }
    std::vector<double> ignored;
    for (std::size_t row = 0; row < element.count; ++row) next(element, ignored);
  }

  // The scalar properties of the next element.
  void next(const Element& element, std::vector<double>& scalars) {
    scalars.clear();
    for (const Property& property : element.properties) {
      if (!property.is_list) {
        scalars.push_back(number(property.type));
        continue;
      }
      const std::size_t begin = at_;
      const auto items = list_size(number(property.count_type));
      if (!items) {
        throw ParseError(source_.name, 0,
                         "byte " + std::to_string(begin) + ": a list of no sensible length");
      }
      step(*items, size_in_bytes(property.type));
    }
  }
  [[nodiscard]] std::size_t at() const { return at_; }

  // The file must still hold `count` times `size` bytes.
  void require(std::size_t count, std::size_t size) const {
    const std::size_t present = source_.bytes.size() - at_;
    if (size == 0 || count <= present / size) return;
    throw ParseError(source_.name, 0,
                     "byte " + std::to_string(source_.bytes.size()) + ": " + std::to_string(count) +
                         " times " + std::to_string(size) + " bytes needed, " +
                         std::to_string(present) + " present; the file is incomplete");
  }

 private:
  void step(std::size_t count, std::size_t size) {
    require(count, size);
    at_ += count * size;
  }
  double number(NumberType type) {
    const std::size_t begin = at_;
    step(1, size_in_bytes(type));
    return number_from_bytes(source_.bytes.data() + begin, type, is_big_endian_);
  }

  const Source& source_;
  std::size_t at_;
  bool is_big_endian_;
};

Reading read_binary(const Source& source, const ReadOptions& options, const Header& header) {
  BinaryBody body(source, header);
  for (const Element& element : header.before) body.skip(element);
  std::size_t least_size = 0;  // of a vertex, with empty lists
  for (const Property& property : header.vertex.properties) {
    least_size += size_in_bytes(property.is_list ? property.count_type : property.type);
  }
  body.require(header.vertex.count, least_size);
  BinaryRows sites(source, chosen_columns(source.name, options,
                                          {.names = header.names,
                                           .columns = header.names.size(),
                                           .numbers = header.names.size(),
                                           .line = 0}));
  if (header.names.size() == header.vertex.properties.size()) {
    std::vector<BinaryColumn> columns;
    for (std::size_t at = body.at(); const Property& property : header.vertex.properties) {
      columns.push_back({at, least_size, property.type});
      at += size_in_bytes(property.type);
    }
    sites.add_columns(header.vertex.count, header.encoding == Encoding::big_endian,
                      [&](std::size_t column) { return columns[column]; });
    return std::move(sites).reading();
  }
  std::vector<double> scalars;  // with lists the lengths differ
  for (std::size_t row = 0; row < header.vertex.count; ++row) {
    const std::size_t begin = body.at();
    body.next(header.vertex, scalars);
    sites.add(scalars, begin);
  }
  return std::move(sites).reading();
}

}  // namespace

Reading read_ply(const Source& source, const ReadOptions& options) {
  HeaderReader reader(source);
  const Header header = reader.header();
  if (!reader.has_xy() && options.columns.empty()) {
    throw ParseError(source.name, header.body.number(),
                     "the vertices have no properties x, y (and z); name others with --columns");
  }
  return header.encoding == Encoding::ascii ? read_ascii(source, options, header)
                                            : read_binary(source, options, header);
}

}  // namespace orthoball
