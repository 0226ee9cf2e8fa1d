// SPDX-License-Identifier: MIT
//
// Tables: fields separated by commas, tabs or blanks, one row a line. The first row tells the
// separator, and is the header if none of its fields is a number. Quotes may enclose a field;
// between commas and tabs such a field may hold separators, doubled quotes and line ends.

#include <optional>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/text_rows.h"

namespace orthoball {
namespace {

constexpr char kBlanks = PlainRows::kBlanks;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool is_comment(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || text.front() == '#' || text.front() == '%' || text.substr(0, 2) == "//";
}

class Rows {
 public:
  explicit Rows(const Source& source) : source_(source), lines_(source.bytes) {}

  // The fields of the next row, without quotes; false at the end. Comments and blank lines are
  // passed over.
  bool next(std::vector<std::string_view>& fields) {
    std::string_view line;
    do {
      if (!lines_.next(line)) return false;
    } while (is_comment(line));
    line_ = lines_.number();
    if (separator_ == '\0') choose_separator(line);
    at_ = line.data();
    end_ = at_ + line.size();
    fields.clear();
    separator_ == kBlanks ? split_at_blanks(fields) : split_at_separators(fields);
    return true;
  }
  // Hands on the plain rows that follow.
  void pass_plain(TextRows& sites) { sites.add_plain(lines_, {.separator = separator_}); }
  // 1-based number of the line on which the row last returned begins.
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw ParseError(source_.name, line_, message);
  }

  void choose_separator(std::string_view line) {
    bool is_quoted = false, has_comma = false, has_tab = false;
    for (const char c : line) {
      if (c == '"') is_quoted = !is_quoted;
      if (is_quoted) continue;
      if (c == ';') {
        fail("semicolons separate the fields; separate them by commas, with points in the numbers");
      }
      has_comma = has_comma || c == ',';
      has_tab = has_tab || c == '\t';
    }
    const std::string_view name = source_.name;
    const bool is_tsv = name.find(".tsv") != std::string_view::npos;
    separator_ = has_comma ? ',' : has_tab && is_tsv ? '\t' : kBlanks;
  }

  // From after an opening quote to after the closing one.
  std::string_view quoted_field() {
    const char* const begin = ++at_;
    for (;;) {
      while (at_ != end_ && *at_ != '"') ++at_;
      if (at_ == end_) {
        std::string_view more;
        if (separator_ == kBlanks || !lines_.next(more)) fail("a quote that is never closed");
        end_ = more.data() + more.size();
      } else if (at_ + 1 != end_ && at_[1] == '"') {
        at_ += 2;
      } else {
        break;
      }
    }
    const std::string_view field(begin, static_cast<std::size_t>(at_ - begin));
    ++at_;
    return field;
  }

  void split_at_blanks(std::vector<std::string_view>& fields) {
    for (;;) {
      while (at_ != end_ && is_blank(*at_)) ++at_;
      if (at_ == end_ || *at_ == '#') return;
      if (*at_ == '"') {
        fields.push_back(quoted_field());
        if (at_ != end_ && !is_blank(*at_)) fail("text after a closing quote; a blank is needed");
        continue;
      }
      const char* const begin = at_;
      while (at_ != end_ && !is_blank(*at_)) ++at_;
      fields.emplace_back(begin, static_cast<std::size_t>(at_ - begin));
    }
  }

  void split_at_separators(std::vector<std::string_view>& fields) {
    const auto skip_blanks = [this] {
      while (at_ != end_ && *at_ != separator_ && is_blank(*at_)) ++at_;
    };
    for (;;) {
      skip_blanks();
      if (at_ != end_ && *at_ == '"') {
        fields.push_back(quoted_field());
        skip_blanks();
        if (at_ != end_ && *at_ != separator_) {
          fail("text after a closing quote; a separator is needed");
        }
      } else {
        const char* const begin = at_;
        while (at_ != end_ && *at_ != separator_) ++at_;
        const char* last = at_;
        while (last != begin && is_blank(last[-1])) --last;
        fields.emplace_back(begin, static_cast<std::size_t>(last - begin));
      }
      if (at_ == end_) return;
      ++at_;
    }
  }

  const Source& source_;
  Lines lines_;
  char separator_ = '\0';
  std::size_t line_ = 0;
  const char* at_ = nullptr;  // the rest of the row
  const char* end_ = nullptr;
};

bool is_header(const std::vector<std::string_view>& fields) {
  for (const std::string_view field : fields) {
    if (parse_decimal(field).fault != DecimalFault::not_a_number) return false;
  }
  return true;
}

std::vector<std::string> header_names(const std::vector<std::string_view>& fields) {
  std::vector<std::string> names;
  for (const std::string_view field : fields) {
    std::string& name = names.emplace_back();
    for (std::size_t i = 0; i < field.size(); ++i) {
      name += field[i];
      if (field.substr(i, 2) == "\"\"") ++i;
    }
  }
  return names;
}

bool is_count(const std::vector<std::string_view>& fields) {
  return fields.size() == 1 && fields[0].find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

Reading read_table(const Source& source, const ReadOptions& options) {
  Rows rows(source);
  TextRows sites(source, options);
  std::vector<std::string_view> fields;
  bool has_row = rows.next(fields);
  if (has_row && is_header(fields)) {
    sites.name_columns(rows.line(), header_names(fields));
    has_row = rows.next(fields);
  }
  // Some point files begin with their number of points, alone on a line.
  std::optional<std::size_t> announced;
  const std::size_t first_line = rows.line();
  if (has_row && is_count(fields)) {
    announced = count_at(source, first_line, fields[0], "the number of points");
    has_row = rows.next(fields);
  }
  for (; has_row; has_row = rows.next(fields)) {
    sites.add(rows.line(), fields);
    rows.pass_plain(sites);
  }
  if (announced && *announced != sites.size()) {
    throw ParseError(source.name, first_line,
                     counted(*announced, "point") + " announced, " + std::to_string(sites.size()) +
                         " found; the two must agree");
  }
  return std::move(sites).reading();
}

}  // namespace orthoball
