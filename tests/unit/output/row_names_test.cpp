// SPDX-License-Identifier: MIT
#include "orthoball/output/row_names.h"

#include <gtest/gtest.h>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

SiteLabels labels() {
  SiteLabels labels;
  labels.chain = {"A", ""};
  labels.residue = {"GLY", ""};
  labels.residue_id = {"7A", "3"};
  labels.atom = {"CA", ""};
  return labels;
}

TEST(RowNames, SayWhoARowIs) {
  const SiteLabels of_two = labels();
  const RowNames names(of_two);
  EXPECT_TRUE(names.has_any());
  EXPECT_EQ(names.residue(0), "GLY 7A");
  EXPECT_EQ(names.path(0), "A/GLY 7A/CA");
  EXPECT_EQ(names.path(1), "/3/");
  EXPECT_EQ(names.path(2), "//");
  EXPECT_EQ(names.element(0), "");
}

TEST(RowNames, AreNoneOfPlainPointsAndOfElements) {
  SiteLabels elements;
  elements.line = {1, 2};
  elements.element = {"C", "C"};
  EXPECT_FALSE(RowNames(elements).has_any());
  elements.atom = {"C1", "C2"};
  EXPECT_TRUE(RowNames(elements).has_any());
  EXPECT_FALSE(RowNames(elements).has_residues());
}

TEST(RowNames, AreFourColumns) {
  const SiteLabels of_two = labels();
  EXPECT_EQ(written([&](ByteSink& sink) {
              TableWriter table(sink, TableFormat::csv, RowNames::columns("_1"));
              for (std::size_t row = 0; row < 3; ++row) RowNames(of_two).write(table, row);
              table.finish();
            }),
            "row_1,chain_1,residue_1,atom_1\n"
            "0,A,GLY 7A,CA\n"
            "1,,3,\n"
            "2,,,\n");
}

}  // namespace
}  // namespace orthoball
