// SPDX-License-Identifier: MIT
#include "orthoball/output/region_tables.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

template <int D>
Void<D> some_void() {
  Void<D> hole;
  hole.volume = 2.5;
  hole.area = 9;
  hole.lining = {{SiteId(1), 4.0}, {SiteId(7), 5.0}};
  hole.born_alpha2 = -0.25;
  hole.dies_alpha2 = 3;
  hole.largest_ball_centre.fill(0.5);
  hole.largest_ball_centre[0] = -0.0;
  hole.largest_ball_radius = 0.125;
  return hole;
}

TEST(VoidTable, HasALineForEveryVoid) {
  const std::array voids{some_void<3>(), some_void<3>()};
  EXPECT_EQ(
      written([&](ByteSink& s) { write_voids<3>(s, TableFormat::csv, voids, VoidsOf::balls, {}); }),
      "void,volume,area,atoms,atom_names,atom_areas,born,dies,x,y,z,radius\n"
      "1,2.5,9,1 7,,4 5,-0.25,3,0,0.5,0.5,0.125\n"
      "2,2.5,9,1 7,,4 5,-0.25,3,0,0.5,0.5,0.125\n");
}

TEST(VoidTable, HasTwoAxesInThePlane) {
  const std::array holes{some_void<2>()};
  EXPECT_EQ(
      written([&](ByteSink& s) { write_voids<2>(s, TableFormat::csv, holes, VoidsOf::balls, {}); }),
      "void,volume,area,atoms,atom_names,atom_areas,born,dies,x,y,radius\n"
      "1,2.5,9,1 7,,4 5,-0.25,3,0,0.5,0.125\n");
}

TEST(VoidTable, LeavesABallThatWasNotFoundEmpty) {
  std::array holes{some_void<2>()};
  holes[0].largest_ball_radius = 0.0;
  holes[0].lining.clear();
  EXPECT_EQ(
      written([&](ByteSink& s) { write_voids<2>(s, TableFormat::csv, holes, VoidsOf::balls, {}); }),
      "void,volume,area,atoms,atom_names,atom_areas,born,dies,x,y,radius\n"
      "1,2.5,9,,,,-0.25,3,,,\n");
}

// Of the rows 0 to 7.
SiteLabels labels() {
  SiteLabels labels;
  for (int row = 0; row < 8; ++row) {
    labels.chain.emplace_back(row < 4 ? "A" : "B");
    labels.residue.emplace_back("ALA");
    labels.residue_id.push_back(std::to_string(row));
    labels.atom.emplace_back("CB");
  }
  return labels;
}

TEST(VoidTable, NamesTheAtomsAround) {
  const std::array holes{some_void<2>()};
  EXPECT_EQ(written([&](ByteSink& s) {
              write_voids<2>(s, TableFormat::csv, holes, VoidsOf::balls, labels());
            }),
            "void,volume,area,atoms,atom_names,atom_areas,born,dies,x,y,radius\n"
            "1,2.5,9,1 7,A/ALA 1/CB;B/ALA 7/CB,4 5,-0.25,3,0,0.5,0.125\n");
}

TEST(VoidTable, HasNoAreasOfTheCornersOfAShape) {
  const std::array holes{some_void<2>()};
  const auto text = [&](TableFormat format) {
    return written([&](ByteSink& s) { write_voids<2>(s, format, holes, VoidsOf::shape, {}); });
  };
  EXPECT_NE(text(TableFormat::csv).find("\n1,2.5,9,1 7,,,-0.25,"), std::string::npos);
  EXPECT_NE(text(TableFormat::json).find(R"("atoms":[1,7],"atom_names":null,"atom_areas":null,)"),
            std::string::npos);
}

TEST(VoidTable, CanBeJson) {
  std::array voids{some_void<3>(), some_void<3>()};
  voids[1].largest_ball_radius = 0.0;
  const auto text_with = [&](const SiteLabels& labels) {
    return written(
        [&](ByteSink& s) { write_voids<3>(s, TableFormat::json, voids, VoidsOf::balls, labels); });
  };
  EXPECT_EQ(
      text_with(labels()),
      "[\n"
      R"({"void":1,"volume":2.5,"area":9,"atoms":[1,7],"atom_names":["A/ALA 1/CB","B/ALA 7/CB"],)"
      R"("atom_areas":[4,5],"born":-0.25,"dies":3,"x":0,"y":0.5,"z":0.5,"radius":0.125},)"
      "\n"
      R"({"void":2,"volume":2.5,"area":9,"atoms":[1,7],"atom_names":["A/ALA 1/CB","B/ALA 7/CB"],)"
      R"("atom_areas":[4,5],"born":-0.25,"dies":3,"x":null,"y":null,"z":null,"radius":null})"
      "\n]\n");
  EXPECT_NE(text_with({}).find(R"("atom_names":null,)"), std::string::npos);
}

Pocket pocket_with(std::vector<Mouth> mouths) {
  Pocket pocket;
  pocket.volume = 2.5;
  pocket.area = 9;
  pocket.lining = {{SiteId(1), 4.0}, {SiteId(7), 5.0}};
  pocket.mouths = std::move(mouths);
  if (!pocket.mouths.empty()) pocket.depth = 0.75;
  return pocket;
}

TEST(PocketTable, HasALineForEveryPocket) {
  const std::vector<Pocket> pockets{pocket_with({}), pocket_with({{3.5, {}, {}}}),
                                    pocket_with({{3.5, {}, {}}, {0.125, {}, {}}}), Pocket()};
  EXPECT_EQ(written([&](ByteSink& s) { write_pockets(s, TableFormat::csv, pockets, {}); }),
            "pocket,kind,volume,area,depth,atoms,atom_names,atom_areas,mouths,mouth_areas\n"
            "1,void,2.5,9,,1 7,,4 5,0,\n"
            "2,pocket,2.5,9,0.75,1 7,,4 5,1,3.5\n"
            "3,channel,2.5,9,0.75,1 7,,4 5,2,3.5 0.125\n"
            "4,void,0,0,,,,,0,\n");
}

TEST(PocketTable, CountsNumbersBeyondTheDoubleRange) {
  std::vector<Pocket> pockets{pocket_with({})};
  pockets[0].volume = std::numeric_limits<double>::infinity();
  std::ostringstream out;
  ByteSink sink(out);
  write_pockets(sink, TableFormat::csv, pockets, {});
  EXPECT_EQ(sink.missing_count(), 1U);
  EXPECT_NE(out.str().find("1,void,,9,"), std::string::npos);
}

}  // namespace
}  // namespace orthoball
