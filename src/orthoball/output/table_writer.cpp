// SPDX-License-Identifier: MIT
#include "orthoball/output/table_writer.h"

#include <utility>

namespace orthoball {
namespace {

void write_field(ByteSink& sink, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return sink.text(text);
  sink.text("\"");
  for (const char& c : text)
    sink.text(c == '"' ? std::string_view("\"\"") : std::string_view(&c, 1));
  sink.text("\"");
}

}  // namespace

TableWriter::TableWriter(ByteSink& sink, TableFormat format, std::vector<std::string> columns)
    : sink_(sink), format_(format), before_(std::move(columns)) {
  if (format_ == TableFormat::json) {
    for (std::string& name : before_) name = (&name == &before_[0] ? "{\"" : ",\"") + name + "\":";
    return;
  }
  for (std::string& name : before_) {
    const bool is_first = &name == &before_[0];
    if (!is_first) sink_.text(",");
    sink_.text(std::exchange(name, is_first ? "" : ","));
  }
  sink_.text("\n");
}

void TableWriter::begin() {
  if (column_ == 0 && format_ == TableFormat::json) sink_.text(has_lines_ ? ",\n" : "[\n");
  has_lines_ = true;
  sink_.text(before_[column_]);
}

void TableWriter::end() {
  if (++column_ < before_.size()) return;
  column_ = 0;
  sink_.text(format_ == TableFormat::json ? "}" : "\n");
}

void TableWriter::none() {
  begin();
  if (format_ == TableFormat::json) sink_.text("null");
  end();
}

void TableWriter::integer(std::int64_t number) {
  begin();
  sink_.integer(number);
  end();
}

void TableWriter::real(double number) {
  begin();
  sink_.real(number + 0.0);
  end();
}

void TableWriter::text(std::string_view text) {
  if (text.empty()) return none();
  begin();
  format_ == TableFormat::json ? sink_.json_string(text) : write_field(sink_, text);
  end();
}

void TableWriter::text_list(const std::vector<std::string>& texts) {
  if (format_ == TableFormat::json) {
    return list(texts, [&](const std::string& text) { sink_.json_string(text); });
  }
  std::string joined;
  for (const std::string& text : texts) joined += (&text == &texts[0] ? "" : ";") + text;
  begin();
  write_field(sink_, joined);
  end();
}

void TableWriter::finish() {
  if (format_ == TableFormat::json) sink_.text(has_lines_ ? "\n]\n" : "[\n]\n");
  sink_.flush();
}

}  // namespace orthoball
