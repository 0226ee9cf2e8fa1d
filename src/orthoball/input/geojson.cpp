// SPDX-License-Identifier: MIT
//
// GeoJSON (RFC 7946): the positions of Point and MultiPoint geometries, alone, in features, in
// collections of either. The text is read as events, so that numbers keep the decimals they have
// in the file. A geometry's type may follow its coordinates, so its positions wait for its end.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/text_rows.h"

namespace orthoball {
namespace {

using Json = nlohmann::json;

// Walks through the text and tells how far the parser has read.
class Tracked {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Tracked(const char* at, const char** furthest) : at_(at), furthest_(furthest) {}
  reference operator*() const { return *at_; }
  Tracked& operator++() {
    *furthest_ = ++at_;
    return *this;
  }
  friend bool operator==(const Tracked& a, const Tracked& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** furthest_;
};

class Events {
 public:
  Events(const Source& source, const ReadOptions& options)
      : source_(source),
        sites_(source, options),
        furthest_(source.bytes.data()),
        counted_(source.bytes.data()) {}

  const char** furthest() { return &furthest_; }
  TextRows& sites() { return sites_; }
  [[nodiscard]] bool has_type() const { return has_type_; }

  // 1-based line of the event at hand: after a number the parser has read one character more.
  std::size_t line() {
    for (; counted_ + 1 < furthest_; ++counted_) line_ += *counted_ == '\n';
    return line_;
  }

  bool null() { return scalar("null", false); }
  bool boolean(bool) { return scalar("true or false", false); }
  bool number_integer(Json::number_integer_t value) { return scalar(std::to_string(value), true); }
  bool number_unsigned(Json::number_unsigned_t value) {
    return scalar(std::to_string(value), true);
  }
  bool number_float(Json::number_float_t, const std::string& text) { return scalar(text, true); }
  bool binary(Json::binary_t&) { return scalar("binary", false); }
  bool string(std::string& text) {
    if (skipped_ == 0 && !objects_.empty() && objects_.back().key == "type") {
      objects_.back().type = text;
      has_type_ = true;
      return true;
    }
    return scalar(orthoball::quoted(text), false);
  }

  bool start_object(std::size_t) {
    if (skipped_ > 0 || !is_followed()) {
      ++skipped_;
    } else {
      if (depth_ > 0) fail("an object among coordinates; numbers are needed");
      objects_.emplace_back();
    }
    return true;
  }
  bool key(std::string& name) {
    if (skipped_ == 0) objects_.back().key = name;
    return true;
  }
  bool end_object() {
    if (skipped_ > 0) {
      --skipped_;
      return true;
    }
    const Object object = std::move(objects_.back());
    objects_.pop_back();
    finish(object);
    return true;
  }

  bool start_array(std::size_t) {
    if (skipped_ > 0 || !is_followed()) {
      ++skipped_;
    } else if (in_coordinates()) {
      Object& object = objects_.back();
      object.depth = std::max(object.depth, ++depth_);
      if (object.line == 0) object.line = line();
      object.position_begin = object.texts.size();
    }
    return true;
  }
  bool end_array() {
    if (skipped_ > 0) {
      --skipped_;
    } else if (in_coordinates()) {
      Object& object = objects_.back();
      if (depth_-- == object.depth) {
        object.sizes.push_back(object.texts.size() - object.position_begin);
        object.lines.push_back(line());
        object.position_begin = object.texts.size();
      }
    }
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) {
    std::string what = error.what();
    const std::size_t at = what.find("syntax error");
    what =
        at == std::string::npos ? "a number out of range" : what.substr(at, what.find(" - ") - at);
    fail("not JSON (" + what + "); a complete GeoJSON text is needed");
  }

 private:
  struct Object {
    std::string key;  // the member at hand
    std::string type;
    std::size_t line = 0;            // where its coordinates begin, 0 if it has none
    int depth = 0;                   // of the arrays in them
    std::vector<std::string> texts;  // of their numbers
    std::size_t position_begin = 0;
    std::vector<std::size_t> sizes;  // [position] how many numbers
    std::vector<std::size_t> lines;  // [position]
  };

  [[noreturn]] void fail(const std::string& message) { fail_at(line(), message); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const {
    throw ParseError(source_.name, line, message);
  }

  [[nodiscard]] bool in_coordinates() const {
    return !objects_.empty() && objects_.back().key == "coordinates";
  }
  // Can sites be below the value that begins here?
  [[nodiscard]] bool is_followed() const {
    if (objects_.empty()) return true;
    const std::string& key = objects_.back().key;
    return key == "coordinates" || key == "geometry" || key == "geometries" || key == "features";
  }

  bool scalar(const std::string& text, bool is_number) {
    if (skipped_ > 0 || !in_coordinates()) return true;
    if (!is_number || depth_ == 0)
      fail("coordinates hold " + text + "; arrays of numbers are needed");
    objects_.back().texts.push_back(text);
    return true;
  }

  void finish(const Object& object) {
    const bool is_point = object.type == "Point", is_many = object.type == "MultiPoint";
    if (!is_point && !is_many) {
      if (object.type == "Feature" || object.type == "FeatureCollection" ||
          object.type == "GeometryCollection") {
        return;
      }
      if (object.line == 0 && object.type.empty()) return;
      fail_at(object.line == 0 ? line() : object.line, "a geometry of type " +
                                                           orthoball::quoted(object.type) +
                                                           "; only Point and MultiPoint are read");
    }
    if (object.line == 0) fail("a " + object.type + " without coordinates; they are needed");
    const bool is_empty = is_many && object.texts.empty() && object.depth <= 2;
    if (is_empty) return;
    std::size_t numbers = 0;
    for (const std::size_t size : object.sizes) numbers += size;
    if (object.depth != (is_point ? 1 : 2) || numbers != object.texts.size() ||
        (is_point && object.sizes.size() != 1)) {
      fail_at(object.line,
              "the coordinates of a " + object.type + " are " +
                  (is_point ? "an array of numbers" : "arrays of numbers in an array"));
    }
    std::vector<std::string_view> fields;
    auto text = object.texts.begin();
    for (std::size_t position = 0; position < object.sizes.size(); ++position) {
      fields.assign(text, text + static_cast<std::ptrdiff_t>(object.sizes[position]));
      text += static_cast<std::ptrdiff_t>(object.sizes[position]);
      sites_.add(object.lines[position], fields);
    }
  }

  const Source& source_;
  TextRows sites_;
  const char* furthest_;  // first character that the parser has not read
  const char* counted_;   // line ends are counted up to here
  std::size_t line_ = 1;
  std::vector<Object> objects_;  // open objects that are followed
  std::size_t skipped_ = 0;      // open objects and arrays below a member that is not followed
  int depth_ = 0;                // of the arrays of coordinates
  bool has_type_ = false;
};

}  // namespace

Reading read_geojson(const Source& source, const ReadOptions& options) {
  Events events(source, options);
  const char* const begin = source.bytes.data();
  Json::sax_parse(Tracked(begin, events.furthest()),
                  Tracked(begin + source.bytes.size(), events.furthest()), &events);
  if (!events.has_type()) {
    throw ParseError(source.name, 1,
                     "an object without type is no GeoJSON; a geometry, a feature "
                     "or a collection is needed");
  }
  return std::move(events.sites()).reading();
}

}  // namespace orthoball
