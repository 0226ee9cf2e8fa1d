// SPDX-License-Identifier: MIT
//
// Object File Format: an optional keyword (OFF, with prefixes for what else a vertex carries), the
// counts of vertices, faces and edges, then one vertex a line. Faces are not needed; what is wrong
// with them is a warning.

#include <algorithm>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/text_rows.h"

namespace orthoball {
namespace {

class Off {
 public:
  explicit Off(const Source& source) : source_(source), lines_(source.bytes) {}

  // Reads up to the first vertex.
  void read_header() {
    if (!next_line())
      fail_at(0, "no OFF header; OFF and the counts of vertices and faces are needed");
    if (fields_[0].find("OFF") != std::string_view::npos) {
      read_keyword(fields_[0]);
      fields_.erase(fields_.begin());
      if (fields_.empty()) require_line("the counts of vertices and faces");
    }
    if (is_n_dimensional_) {
      axes_ = count_at(source_, lines_.number(), fields_[0], "the dimension");
      if (axes_ != 2 && axes_ != 3)
        fail("the dimension is " + quoted(fields_[0]) + "; 2 or 3 is read");
      fields_.erase(fields_.begin());
      if (fields_.empty()) require_line("the counts of vertices and faces");
    }
    vertices_ = count_at(source_, lines_.number(), fields_[0], "the number of vertices");
    if (fields_.size() > 1) {
      faces_ = count_at(source_, lines_.number(), fields_[1], "the number of faces");
    }
  }

  void read_vertices(TextRows& sites) {
    for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
      if (!next_line()) {
        fail_at(lines_.number(), counted(vertices_, "vertex") + " announced, " +
                                     std::to_string(vertex) + " found; the two must agree");
      }
      if (fields_.size() < axes_)
        fail("a vertex with fewer than " + std::to_string(axes_) +
             " coordinates; each vertex needs all of them on one line");
      if (vertex == 0) {
        std::vector<std::string> names{"x", "y", "z"};
        names.resize(axes_);
        names.resize(fields_.size());
        sites.name_columns(lines_.number(), std::move(names));
      }
      sites.add(lines_.number(), fields_);
      vertex += sites.add_plain(lines_, {.most = vertices_ - vertex - 1});
    }
  }

  // What is wrong with the faces first, in words; empty if nothing is.
  std::string face_fault() {
    for (std::size_t face = 0; face < faces_; ++face) {
      if (!next_line()) {
        return std::to_string(faces_) + " faces announced, " + std::to_string(face) + " found";
      }
      const auto at_line = [this](const std::string& what) {
        return "line " + std::to_string(lines_.number()) + ": " + what;
      };
      const DecimalParse corners = parse_decimal(fields_[0]);
      if (corners.fault != DecimalFault::none || !(corners.number.nearest >= 0.0) ||
          corners.number.nearest >= static_cast<double>(fields_.size())) {
        return at_line("not a face");
      }
      for (std::size_t i = 1; static_cast<double>(i) <= corners.number.nearest; ++i) {
        const DecimalParse corner = parse_decimal(fields_[i]);
        if (corner.fault == DecimalFault::none && corner.number.nearest >= 0.0 &&
            corner.number.nearest < static_cast<double>(vertices_)) {
          continue;
        }
        return at_line("there is no vertex " + quoted(fields_[i]));
      }
    }
    return {};
  }

 private:
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const {
    throw ParseError(source_.name, line, message);
  }
  [[noreturn]] void fail(const std::string& message) const { fail_at(lines_.number(), message); }

  // The fields of the next line that has any.
  bool next_line() {
    std::string_view line;
    while (lines_.next(line)) {
      split_at_blanks(line.substr(0, line.find('#')), fields_);
      if (!fields_.empty()) return true;
    }
    return false;
  }
  void require_line(const std::string& what) {
    if (!next_line()) fail(what + " are missing");
  }

  void read_keyword(std::string_view keyword) {
    const std::string_view prefix = keyword.substr(0, keyword.find("OFF"));
    if (keyword.substr(prefix.size()) != "OFF" ||
        prefix.find_first_not_of("STCN4n") != std::string_view::npos) {
      fail(quoted(keyword) + " is not OFF; the first line must say so");
    }
    if (prefix.find('4') != std::string_view::npos) {
      fail("vertices with four coordinates; 2 or 3 are read, as OFF or nOFF");
    }
    is_n_dimensional_ = prefix.find('n') != std::string_view::npos;
    if (fields_.size() > 1 && fields_[1] == "BINARY") {
      fail("binary OFF; convert it to ASCII OFF or PLY");
    }
  }

  const Source& source_;
  Lines lines_;
  std::vector<std::string_view> fields_;  // of the line last read
  bool is_n_dimensional_ = false;
  std::size_t axes_ = 3;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
};

}  // namespace

Reading read_off(const Source& source, const ReadOptions& options) {
  Off off(source);
  TextRows sites(source, options);
  off.read_header();
  off.read_vertices(sites);
  const std::string fault = off.face_fault();
  Reading reading = std::move(sites).reading();
  if (!fault.empty()) reading.warnings.push_back(fault + "; faces are not used");
  return reading;
}

}  // namespace orthoball
