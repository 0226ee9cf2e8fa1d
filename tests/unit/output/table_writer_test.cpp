// SPDX-License-Identifier: MIT
#include "orthoball/output/table_writer.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

std::string table_of(TableFormat format, const std::vector<std::vector<std::string>>& lines) {
  return written([&](ByteSink& sink) {
    TableWriter table(sink, format, {"name", "count", "size", "parts", "areas", "none"});
    for (const auto& line : lines) {
      table.text(line[0]);
      table.integer(-7);
      table.real(-0.0);
      table.texts(line, [](const std::string& text) { return text; });
      table.reals(line, [](const std::string& text) { return 0.5 * double(text.size()); });
      table.none();
    }
    table.finish();
  });
}

TEST(TableWriter, QuotesFieldsOfCsv) {
  EXPECT_EQ(table_of(TableFormat::csv, {{"a", "b c"}, {"\"1,\"", "\n"}, {""}}),
            "name,count,size,parts,areas,none\n"
            "a,-7,0,a;b c,0.5 1.5,\n"
            "\"\"\"1,\"\"\",-7,0,\"\"\"1,\"\";\n\",2 0.5,\n"
            ",-7,0,,0,\n");
}

TEST(TableWriter, HasTheKeysInEveryObjectOfJson) {
  EXPECT_EQ(
      table_of(TableFormat::json, {{"a", "b\"c"}, {""}}),
      "[\n"
      R"({"name":"a","count":-7,"size":0,"parts":["a","b\"c"],"areas":[0.5,1.5],"none":null},)"
      "\n"
      R"({"name":null,"count":-7,"size":0,"parts":[""],"areas":[0],"none":null})"
      "\n]\n");
}

TEST(TableWriter, MayHaveNoLines) {
  EXPECT_EQ(table_of(TableFormat::csv, {}), "name,count,size,parts,areas,none\n");
  EXPECT_EQ(table_of(TableFormat::json, {}), "[\n]\n");
}

TEST(TableWriter, MayHaveEmptyLists) {
  for (const TableFormat format : {TableFormat::csv, TableFormat::json}) {
    const std::string text = written([&](ByteSink& sink) {
      TableWriter table(sink, format, {"a", "b"});
      const std::vector<int> nothing;
      table.integers(nothing, [](int i) { return i; });
      table.texts(nothing, [](int i) { return std::to_string(i); });
      table.finish();
    });
    EXPECT_EQ(text, format == TableFormat::csv ? "a,b\n,\n" : "[\n{\"a\":[],\"b\":[]}\n]\n");
  }
}

TEST(TableWriter, CountsNumbersBeyondTheDoubleRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const TableFormat format : {TableFormat::csv, TableFormat::json}) {
    std::ostringstream out;
    ByteSink sink(out, format == TableFormat::csv ? "" : "null");
    TableWriter table(sink, format, {"a", "b"});
    table.real(kInfinity);
    table.reals(std::vector<double>{1, kInfinity, 2}, [](double x) { return x; });
    table.finish();
    EXPECT_EQ(sink.missing_count(), 2U);
    EXPECT_EQ(out.str(), format == TableFormat::csv ? "a,b\n,1  2\n"
                                                    : "[\n{\"a\":null,\"b\":[1,null,2]}\n]\n");
  }
}

}  // namespace
}  // namespace orthoball
