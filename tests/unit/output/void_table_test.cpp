// SPDX-License-Identifier: MIT
#include "orthoball/output/void_table.h"

#include <gtest/gtest.h>

#include <array>
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
  EXPECT_EQ(written([&](ByteSink& s) { write_voids_csv<3>(s, voids); }),
            "void,volume,area,atoms,atom_areas,born,dies,x,y,z,radius\n"
            "1,2.5,9,1 7,4 5,-0.25,3,0,0.5,0.5,0.125\n"
            "2,2.5,9,1 7,4 5,-0.25,3,0,0.5,0.5,0.125\n");
}

TEST(VoidTable, HasTwoAxesInThePlane) {
  const std::array holes{some_void<2>()};
  EXPECT_EQ(written([&](ByteSink& s) { write_voids_csv<2>(s, holes); }),
            "void,volume,area,atoms,atom_areas,born,dies,x,y,radius\n"
            "1,2.5,9,1 7,4 5,-0.25,3,0,0.5,0.125\n");
}

TEST(VoidTable, LeavesABallThatWasNotFoundEmpty) {
  std::array holes{some_void<2>()};
  holes[0].largest_ball_radius = 0.0;
  holes[0].lining.clear();
  EXPECT_EQ(written([&](ByteSink& s) { write_voids_csv<2>(s, holes); }),
            "void,volume,area,atoms,atom_areas,born,dies,x,y,radius\n"
            "1,2.5,9,,,-0.25,3,,,\n");
}

}  // namespace
}  // namespace orthoball
