// SPDX-License-Identifier: MIT
#include "orthoball/output/ball_tables.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

// Four rows: two atoms of a residue, one of another, and an imaginary ball.
WeightedPoints points() {
  return WeightedPoints::fixed_point(2, 1, {0, 0, 1, 0, 2, 0, 9, 9}, WeightKind::radius,
                                     {17, 15, 12, -5});
}

SiteLabels labels() {
  SiteLabels labels;
  labels.chain = {"A", "B,1", "A", ""};
  labels.residue = {"ALA", "GLY", "ALA", ""};
  labels.residue_id = {"12", "7A", "12", ""};
  labels.atom = {"CA", "H5\"", "CB", ""};
  labels.element = {"C", "H", "C", "Xe"};
  return labels;
}

UnionOfBalls balls() {
  UnionOfBalls balls;
  balls.areas = {1.5, 0.25, 2, 0};
  balls.volumes = {4, 0.5, 8, 0};
  balls.contacts = {{{SiteId(0), SiteId(2)}, 0.75, 1.25}, {{SiteId(1), SiteId(2)}, 3, 0}};
  return balls;
}

TEST(BallTable, HasALineForEveryRow) {
  EXPECT_EQ(
      written([](ByteSink& s) { write_balls(s, TableFormat::csv, balls(), points(), labels()); }),
      "row,chain,residue,atom,element,radius,area,volume\n"
      "0,A,ALA 12,CA,C,1.7,1.5,4\n"
      "1,\"B,1\",GLY 7A,\"H5\"\"\",H,1.5,0.25,0.5\n"
      "2,A,ALA 12,CB,C,1.2,2,8\n"
      "3,,,,Xe,,0,0\n");
}

TEST(BallTable, LeavesWhatIsNotKnownEmpty) {
  UnionOfBalls union_of_two;
  union_of_two.alpha2 = 2.25;
  union_of_two.areas = {1, 1};
  union_of_two.volumes = {2, -0.0};
  const WeightedPoints bare(3, {0, 0, 0, 1, 1, 1}, WeightKind::none, {});
  EXPECT_EQ(written([&](ByteSink& s) { write_balls(s, TableFormat::csv, union_of_two, bare, {}); }),
            "row,chain,residue,atom,element,radius,area,volume\n"
            "0,,,,,1.5,1,2\n"
            "1,,,,,1.5,1,0\n");
}

TEST(BallTable, CanBeJson) {
  EXPECT_EQ(
      written([](ByteSink& s) { write_balls(s, TableFormat::json, balls(), points(), labels()); }),
      "[\n"
      R"({"row":0,"chain":"A","residue":"ALA 12","atom":"CA","element":"C","radius":1.7,"area":1.5,"volume":4},)"
      "\n"
      R"({"row":1,"chain":"B,1","residue":"GLY 7A","atom":"H5\"","element":"H","radius":1.5,"area":0.25,"volume":0.5},)"
      "\n"
      R"({"row":2,"chain":"A","residue":"ALA 12","atom":"CB","element":"C","radius":1.2,"area":2,"volume":8},)"
      "\n"
      R"({"row":3,"chain":null,"residue":null,"atom":null,"element":"Xe","radius":null,"area":0,"volume":0})"
      "\n]\n");
}

TEST(BallTable, CountsNumbersBeyondTheDoubleRange) {
  UnionOfBalls huge = balls();
  huge.volumes[0] = std::numeric_limits<double>::infinity();
  std::ostringstream out;
  ByteSink sink(out);
  write_balls(sink, TableFormat::csv, huge, points(), labels());
  EXPECT_EQ(sink.missing_count(), 1U);
  EXPECT_NE(out.str().find("1.7,1.5,\n"), std::string::npos);
}

TEST(ResidueTable, SumsInTheOrderOfFirstAppearance) {
  EXPECT_EQ(written([](ByteSink& s) { write_residues(s, TableFormat::csv, balls(), labels()); }),
            "chain,residue,atoms,area,volume\n"
            "A,ALA 12,2,3.5,12\n"
            "\"B,1\",GLY 7A,1,0.25,0.5\n"
            ",,1,0,0\n");
  EXPECT_EQ(written([](ByteSink& s) { write_residues(s, TableFormat::csv, balls(), {}); }),
            "chain,residue,atoms,area,volume\n"
            ",,4,3.75,12.5\n");
}

TEST(ContactTable, HasALineForEveryPair) {
  EXPECT_EQ(
      written([](ByteSink& s) { write_contacts(s, TableFormat::csv, balls().contacts, labels()); }),
      "row_1,chain_1,residue_1,atom_1,row_2,chain_2,residue_2,atom_2,area,exposed_length\n"
      "0,A,ALA 12,CA,2,A,ALA 12,CB,0.75,1.25\n"
      "1,\"B,1\",GLY 7A,\"H5\"\"\",2,A,ALA 12,CB,3,0\n");
}

TEST(ContactTable, LeavesNamesOfPlainPointsEmpty) {
  EXPECT_EQ(written([](ByteSink& s) {
              write_contacts(s, TableFormat::csv, std::vector{balls().contacts[0]}, {});
            }),
            "row_1,chain_1,residue_1,atom_1,row_2,chain_2,residue_2,atom_2,area,exposed_length\n"
            "0,,,,2,,,,0.75,1.25\n");
}

TEST(ResidueContactTable, SumsPairsOfDifferentResidues) {
  UnionOfBalls three = balls();
  three.contacts = {{{SiteId(0), SiteId(1)}, 0.5, 1},
                    {{SiteId(0), SiteId(2)}, 0.75, 1},
                    {{SiteId(1), SiteId(2)}, 3, 0},
                    {{SiteId(1), SiteId(3)}, 0.25, 0}};
  EXPECT_EQ(written([&](ByteSink& s) {
              write_residue_contacts(s, TableFormat::csv, three.contacts, 4, labels());
            }),
            "chain_1,residue_1,chain_2,residue_2,pairs,area\n"
            "A,ALA 12,\"B,1\",GLY 7A,2,3.5\n"
            "\"B,1\",GLY 7A,,,1,0.25\n");
}

TEST(DerivativeTable, HasAsManyAxesAsThereAre) {
  UnionOfBalls moved = balls();
  moved.areas = {1.5, 2};
  moved.derivatives = {{0.5, -1}, {1, 2, 3, 4}, {-0.0, 6, 7, 8}};
  EXPECT_EQ(
      written([&](ByteSink& s) { write_derivatives(s, TableFormat::csv, moved, 2, labels()); }),
      "row,chain,residue,atom,area_by_radius,volume_by_radius,volume_by_x,volume_by_y,area_by_x,"
      "area_by_y\n"
      "0,A,ALA 12,CA,0.5,1.5,1,2,0,6\n"
      "1,\"B,1\",GLY 7A,\"H5\"\"\",-1,2,3,4,7,8\n");
  moved.derivatives = {{0.5}, {1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(
      written([&](ByteSink& s) { write_derivatives(s, TableFormat::csv, moved, 3, labels()); }),
      "row,chain,residue,atom,area_by_radius,volume_by_radius,volume_by_x,volume_by_y,volume_by_z,"
      "area_by_x,"
      "area_by_y,area_by_z\n"
      "0,A,ALA 12,CA,0.5,1.5,1,2,3,4,5,6\n");
}

}  // namespace
}  // namespace orthoball
