// SPDX-License-Identifier: MIT
#include "orthoball/output/union_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "orthoball/error.h"
#include "unit/output/shapes.h"

namespace orthoball {
namespace {

// Three disks around a triangle, one that touches none, one on the edge of another.
Shapes<2> five_disks() { return Shapes<2>({0, 0, 2, 0, 1, 2, 9, 0, 3.5, 0}); }

std::string figure(const Shapes<2>& shapes, UnionFigureOptions options) {
  options.index = shapes.filtration.index(options.alpha2);
  return written(
      [&](ByteSink& s) { write_union_figure(s, shapes.filtration, shapes.points, options); });
}

UnionFigureOptions at(double alpha2) {
  UnionFigureOptions options;
  options.alpha2 = alpha2;
  return options;
}

// The data of the path of a class.
std::string path(const std::string& svg, const std::string& name) {
  const std::size_t at = svg.find("class=\"" + name + "\"");
  if (at == std::string::npos) return "none";
  const std::size_t begin = svg.find(" d=\"", at) + 4;
  return svg.substr(begin, svg.find('"', begin) - begin);
}
long count(const std::string& text, char what) {
  return std::count(text.begin(), text.end(), what);
}

TEST(UnionFigure, DrawsTheSimplicesOfTheDualComplexByRole) {
  const std::string svg = figure(five_disks(), at(1.6));
  EXPECT_EQ(count(path(svg, "triangles"), 'Z'), 1);
  EXPECT_EQ(count(path(svg, "interior edges"), 'M'), 0);
  EXPECT_EQ(count(path(svg, "regular edges"), 'M'), 3);
  EXPECT_EQ(count(path(svg, "singular edges"), 'M'), 1);
  EXPECT_EQ(count(path(svg, "singular vertices"), 'M'), 1);
  EXPECT_EQ(count(path(svg, "sites"), 'M'), 5);
  EXPECT_EQ(count(path(svg, "parts"), 'Z'), 5);
  EXPECT_EQ(count(path(svg, "circles"), 'Z'), 5);
  EXPECT_EQ(count(path(svg, "union"), 'Z'), 2);
  EXPECT_EQ(path(svg, "union").find('L'), std::string::npos);  // arcs only
  EXPECT_EQ(count(path(svg, "parts"), 'L'), 8);                // both sides of four segments
}

TEST(UnionFigure, HasWordsAround) {
  UnionFigureOptions options = at(1.0);
  options.title = "a < b";
  options.unit = "m";
  const std::string svg = figure(five_disks(), options);
  EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
  EXPECT_NE(svg.find("5 disks, area"), std::string::npos);
  EXPECT_NE(svg.find("\u2009m, "), std::string::npos);
  EXPECT_NE(svg.find("(c) the dual complex"), std::string::npos);
  EXPECT_NE(svg.find("singular vertex"), std::string::npos);
  options.legend = false;
  EXPECT_EQ(figure(five_disks(), options).find("<text"), std::string::npos);
}

TEST(UnionFigure, DrawsThePanelsThatAreAskedFor) {
  UnionFigureOptions options = at(1.0);
  options.panels = {FigurePanel::cells};
  const std::string svg = figure(five_disks(), options);
  EXPECT_NE(path(svg, "parts"), "none");
  EXPECT_EQ(path(svg, "circles"), "none");
  EXPECT_EQ(path(svg, "triangles"), "none");
  EXPECT_EQ(svg.find("singular vertex"), std::string::npos);  // no legend of what is not there
  EXPECT_NE(svg.find(">the parts"), std::string::npos);       // no letter either
}

TEST(UnionFigure, ADiskIsDrawnInItsPlace) {
  UnionFigureOptions options = at(4.0);
  options.panels = {FigurePanel::disks};
  options.legend = false;
  options.panel_width = 120;
  // Of radius 2 in 100 pixels: the centre in the middle, y upwards.
  const std::string svg = figure(Shapes<2>({5, 7}), options);
  EXPECT_EQ(path(svg, "union"),
            "M110 60A50 50 0 0 0 60 10A50 50 0 0 0 10 60A50 50 0 0 0 60 110A50 50 0 0 0 110 60Z");
  EXPECT_NE(svg.find("width=\"120\" height=\"120\""), std::string::npos);
}

TEST(UnionFigure, PrintsInGrey) {
  UnionFigureOptions options = at(1.6);
  options.style = FigureStyle::print;
  const std::string svg = figure(five_disks(), options);
  EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos);
  for (std::size_t at = svg.find('#'); at != std::string::npos; at = svg.find('#', at + 1)) {
    const std::string colour = svg.substr(at + 1, 6);
    EXPECT_TRUE(colour.substr(0, 2) == colour.substr(2, 2) &&
                colour.substr(2, 2) == colour.substr(4, 2))
        << colour;
  }
}

TEST(UnionFigure, OfNothingHasASize) {
  for (const double alpha2 : {-1.0, 0.0, -std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(figure(Shapes<2>({}), at(alpha2)).find("width=\"1304\""), std::string::npos);
    EXPECT_NE(figure(Shapes<2>({1, 1, 2, 2}), at(alpha2)).find("</svg>"), std::string::npos);
  }
}

TEST(UnionFigure, RefusesDisksBeyondTheRangeOfDoubles) {
  EXPECT_THROW((void)figure(Shapes<2>({0, 0, 1, 0}), at(std::numeric_limits<double>::infinity())),
               InputError);
}

}  // namespace
}  // namespace orthoball
