// SPDX-License-Identifier: MIT
#include "orthoball/output/signature_plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

template <int D>
std::string plot(const Shapes<D>& shapes, PlotOptions options) {
  SignaturePlot<D> picture(shapes.filtration, std::move(options));
  scan_signatures<D>(shapes.filtration, [&](const Signature<D>& s) { picture.add(s); });
  return written([&](ByteSink& s) { picture.write(s); });
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++found;
  }
  return found;
}

TEST(SignaturePlot, HasAPanelForEveryBettiNumberAndMeasure) {
  const std::string space = plot(mixed_shapes(), {});
  EXPECT_EQ(count(space, "class=\"curve\""), 8U);
  for (const char* const title : {"betti 0", "betti 1", "betti 2", "Volume", "Surface area",
                                  "Length", "alpha (input unit)"}) {
    EXPECT_NE(space.find(title), std::string::npos) << title;
  }
  const std::string plane = plot(Shapes<2>({0, 0, 1, 0, 0, 1}), {});
  EXPECT_EQ(count(plane, "class=\"curve\""), 6U);
  EXPECT_EQ(plane.find("Length"), std::string::npos);
}

TEST(SignaturePlot, ExplainsTheLettersOfMarksAndListsThoseOutsideTheRange) {
  const PlotOptions options{.title = "a & b",
                            .subtitle = "",
                            .unit = std::string("Å"),
                            .range = std::pair(0.0, 2.0),
                            .marks = {{"far", 3, 100.0}, {"solid", 2, 1.0}, {"before", 1, -4.0}}};
  const std::string svg = plot(mixed_shapes(), options);
  EXPECT_NE(svg.find(">A solid (1)<"), std::string::npos);
  EXPECT_NE(svg.find(">\u2192 far (10)<"), std::string::npos);
  EXPECT_NE(svg.find(">\u2190 before (-2)<"), std::string::npos);
  EXPECT_NE(svg.find(">a &amp; b<"), std::string::npos);
  EXPECT_NE(svg.find("alpha (Å)"), std::string::npos);
  EXPECT_NE(svg.find("not shown: 2 to "), std::string::npos);
}

TEST(SignaturePlot, NamesIndicesExactly) {
  const std::string svg = plot(mixed_shapes(), {.title = "",
                                                .subtitle = "",
                                                .unit = "",
                                                .axis = PlotAxis::index,
                                                .range = std::pair(0.0, 200000.0),
                                                .marks = {{"solid", 160901, 1.0}}});
  EXPECT_NE(svg.find(">A solid (160901)<"), std::string::npos);
}

TEST(SignaturePlot, ShortensLongTextsAndKeepsThemWholeInTheDescription) {
  const std::string name(150, 'n'), what(300, 'w');
  PlotOptions options;
  options.title = name;
  options.subtitle = what;
  const std::string svg = plot(mixed_shapes(), options);
  EXPECT_NE(svg.find("<title>Signatures of " + name + "</title>"), std::string::npos);
  EXPECT_NE(svg.find("<desc>" + what + "</desc>"), std::string::npos);
  EXPECT_NE(svg.find("nn\u2026</text>"), std::string::npos);
  EXPECT_NE(svg.find("ww\u2026</text>"), std::string::npos);
}

TEST(SignaturePlot, SaysWhatIsBeyondTheDoubleRange) {
  const Shapes<2> shapes({0, 0, 1e200, 0, 0, 1e200});
  PlotOptions options;
  options.marks = {{"connected", 2, shapes.filtration.alpha2(2)}};
  const std::string svg = plot(shapes, options);
  EXPECT_NE(svg.find(">not shown: 1 and beyond<"), std::string::npos);
  EXPECT_NE(svg.find("connected (beyond double range)<"), std::string::npos);
}

TEST(SignaturePlot, BeginsAndEndsWithinTheDoubleRange) {
  const std::vector<std::vector<double>> radii{
      {1e200}, {1e200, 1.0, 1.0}, {1e200, 1e200, 1e200}, {1e154}};
  for (const auto& each : radii) {
    std::vector<double> coordinates;
    for (std::size_t i = 0; i < each.size(); ++i) {
      const auto x = static_cast<double>(i);
      coordinates.insert(coordinates.end(), {3e200 * x, x * x});
    }
    const WeightedPoints points(2, std::move(coordinates), WeightKind::radius, each);
    const Filtration<2> filtration(regular_triangulation<2>(points));
    for (const PlotAxis axis : {PlotAxis::alpha, PlotAxis::alpha2}) {
      PlotOptions options;
      options.axis = axis;
      SignaturePlot<2> picture(filtration, options);
      scan_signatures<2>(filtration, [&](const Signature<2>& s) { picture.add(s); });
      const std::string svg = written([&](ByteSink& s) { picture.write(s); });
      EXPECT_EQ(count(svg, "class=\"curve\""), 6U);
      EXPECT_EQ(svg.find("range and beyond"), std::string::npos) << svg;
      EXPECT_EQ(svg.find("nan"), std::string::npos) << svg;
      EXPECT_EQ(svg.find("inf"), std::string::npos) << svg;
    }
  }
}

TEST(SignaturePlot, WidensARangeWithoutRoomForTicks) {
  for (const PlotAxis axis : {PlotAxis::alpha2, PlotAxis::index}) {
    for (const double from : {1e17, -1e17, 1e300}) {
      PlotOptions options;
      options.axis = axis;
      options.range = std::pair(from, std::nextafter(from, 1e301));
      EXPECT_EQ(count(plot(mixed_shapes(), options), "class=\"curve\""), 8U);
    }
  }
}

TEST(SignaturePlot, OfNothingIsAPictureToo) {
  EXPECT_EQ(count(plot(Shapes<3>({}), {}), "class=\"curve\""), 8U);
  EXPECT_EQ(count(plot(Shapes<2>({1, 1}), {}), "class=\"curve\""), 6U);
}

}  // namespace
}  // namespace orthoball
