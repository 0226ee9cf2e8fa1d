// SPDX-License-Identifier: MIT
#include "orthoball/output/signature_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

// The signatures of a right triangle, or none, as a table.
std::string table_of(SignatureFormat format, bool with_rows) {
  const Shapes<2> shapes({0, 0, 4, 0, 0, 3});
  return written([&](ByteSink& sink) {
    SignatureTable<2> table(sink, format);
    if (with_rows) {
      scan_signatures<2>(shapes.filtration, [&](const Signature<2>& s) { table.add({s, 7.0}); });
    }
    table.finish();
  });
}

TEST(SignatureTable, CsvIsAHeadAndALineForEveryRow) {
  const std::string csv = table_of(SignatureFormat::csv, true);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_EQ(csv.find("index,alpha2,alpha,"), 0U);
  EXPECT_NE(csv.find("\n4,6.25,7,1,0,"), std::string::npos);
  const std::string head = table_of(SignatureFormat::csv, false);
  EXPECT_EQ(csv.find(head), 0U);
  EXPECT_EQ(std::count(head.begin(), head.end(), '\n'), 1);
}

TEST(SignatureTable, JsonIsAnArrayOfObjects) {
  const auto json = nlohmann::json::parse(table_of(SignatureFormat::json, true));
  ASSERT_EQ(json.size(), 4U);
  EXPECT_EQ(json[3]["alpha2"], 6.25);
  EXPECT_EQ(json[3]["alpha"], 7.0);
  EXPECT_TRUE(nlohmann::json::parse(table_of(SignatureFormat::json, false)).empty());
}

TEST(SignatureTable, NpzIsWhatIsWrittenOfAllRows) {
  const Shapes<2> shapes({0, 0, 4, 0, 0, 3});
  std::vector<SignatureRow<2>> rows;
  scan_signatures<2>(shapes.filtration, [&](const Signature<2>& s) { rows.push_back({s, 7.0}); });
  EXPECT_EQ(table_of(SignatureFormat::npz, true),
            written([&](ByteSink& sink) { write_signatures_npz(sink, rows); }));
}

}  // namespace
}  // namespace orthoball
