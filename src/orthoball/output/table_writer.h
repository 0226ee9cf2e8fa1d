// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/output/byte_sink.h"

namespace orthoball {

/// How a table is written; the sink's `missing` is to be "" for CSV and "null" for JSON.
enum class TableFormat {
  csv,   ///< texts with commas or quotation marks quoted as RFC 4180 says; no value is an empty
         ///< field
  json,  ///< an array of objects, one a line, keys as the columns; no value is null
};

/// A table with named columns, cell by cell from left to right; the last one ends its line.
class TableWriter {
 public:
  TableWriter(ByteSink& sink, TableFormat format, std::vector<std::string> columns);

  /// A cell with no value.
  void none();
  /// A cell with a number.
  void integer(std::int64_t number);
  /// The same, as ByteSink writes it; no -0.
  void real(double number);
  /// A cell with a text; with no value where that is empty.
  void text(std::string_view text);

  /// A list in one cell, an array in JSON; in CSV with blanks between, texts with semicolons.
  /// @param of  gives the number or text of an item.
  template <class Items, class Of>
  void integers(const Items& items, const Of& of) {
    list(items, [&](const auto& item) { sink_.integer(of(item)); });
  }
  template <class Items, class Of>
  void reals(const Items& items, const Of& of) {
    list(items, [&](const auto& item) { sink_.real(of(item) + 0.0); });
  }
  template <class Items, class Of>
  void texts(const Items& items, const Of& of) {
    std::vector<std::string> texts;
    for (const auto& item : items) texts.emplace_back(of(item));
    text_list(texts);
  }

  /// After the last line; flushes the sink.
  void finish();

 private:
  template <class Items, class Write>
  void list(const Items& items, const Write& write) {
    begin();
    const bool is_json = format_ == TableFormat::json;
    std::string_view before = is_json ? "[" : "";
    for (const auto& item : items) {
      sink_.text(before);
      write(item);
      before = is_json ? "," : " ";
    }
    if (is_json) sink_.text(items.empty() ? "[]" : "]");
    end();
  }
  void text_list(const std::vector<std::string>& texts);
  void begin();
  void end();

  ByteSink& sink_;
  TableFormat format_;
  std::vector<std::string> before_;  // [column]: what stands before its cell
  std::size_t column_ = 0;
  bool has_lines_ = false;
};

}  // namespace orthoball
