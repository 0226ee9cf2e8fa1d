// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "orthoball/input/read.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"
#include "python/module.h"

/// What `write(sink)` writes, while other Python threads run; it must not touch Python.
/// @param missing  what stands for numbers that are not finite.
template <class Write>
[[nodiscard]] nanobind::bytes written(std::string_view missing, const Write& write) {
  std::string text;
  {
    const nanobind::gil_scoped_release released;
    std::ostringstream stream;
    orthoball::ByteSink sink(stream, missing);
    write(sink);
    sink.flush();
    text = std::move(stream).str();
  }
  return nanobind::bytes(text.data(), text.size());
}

/// Throws the InputError for a format that there is not.
/// @param formats  those that there are: "csv and json".
[[noreturn]] inline void refuse_format(const std::string& format, const std::string& formats) {
  refuse("\"" + format + "\" is no format of this; there are " + formats);
}

/// What `write(sink, format)` writes as a table, "csv" or "json".
template <class Write>
[[nodiscard]] nanobind::bytes written_table(const std::string& format, const Write& write) {
  using orthoball::TableFormat;
  if (format != "csv" && format != "json") refuse_format(format, "csv and json");
  const TableFormat of_table = format == "json" ? TableFormat::json : TableFormat::csv;
  return written(of_table == TableFormat::json ? "null" : "",
                 [&](orthoball::ByteSink& sink) { write(sink, of_table); });
}

/// Who the rows are; nobody where there is no reading.
[[nodiscard]] inline const orthoball::SiteLabels& labels_of(const orthoball::Reading* reading) {
  static const orthoball::SiteLabels none;
  return reading ? reading->labels : none;
}
