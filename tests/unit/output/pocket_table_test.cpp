// SPDX-License-Identifier: MIT
#include "orthoball/output/pocket_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <vector>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

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
  EXPECT_EQ(written([&](ByteSink& s) { write_pockets_csv(s, pockets); }),
            "pocket,kind,volume,area,depth,atoms,mouths,mouth_areas\n"
            "1,void,2.5,9,,1 7,0,\n"
            "2,pocket,2.5,9,0.75,1 7,1,3.5\n"
            "3,channel,2.5,9,0.75,1 7,2,3.5 0.125\n"
            "4,void,0,0,,,0,\n");
}

TEST(PocketTable, CountsNumbersBeyondTheDoubleRange) {
  std::vector<Pocket> pockets{pocket_with({})};
  pockets[0].volume = std::numeric_limits<double>::infinity();
  std::ostringstream out;
  ByteSink sink(out);
  write_pockets_csv(sink, pockets);
  EXPECT_EQ(sink.missing_count(), 1U);
  EXPECT_NE(out.str().find("1,void,,9,"), std::string::npos);
}

}  // namespace
}  // namespace orthoball
