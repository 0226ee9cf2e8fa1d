// SPDX-License-Identifier: MIT
#include "orthoball/output/plot_panel.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace orthoball {
namespace {

TEST(PlotPanel, TicksAreMultiplesOfOneTwoOrFive) {
  EXPECT_EQ(tick_values(0.0, 10.0, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(tick_values(-1.0, 1.0, 4), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
  EXPECT_TRUE(tick_values(1.0, 1.0, 4).empty());
  for (const double high : {0.0037, 1.0, 8.6, 123.0, 4.4e7}) {
    const auto ticks = tick_values(0.0, high, 4);
    EXPECT_GE(ticks.size(), 3U) << high;
    EXPECT_LE(ticks.size(), 8U) << high;
  }
}

TEST(PlotPanel, TickNumbersHaveTheDecimalsOfTheirStep) {
  EXPECT_EQ(tick_text(0.5, 0.1), "0.5");
  EXPECT_EQ(tick_text(1.0, 0.25), "1.0");
  EXPECT_EQ(tick_text(12345.0, 5.0), "12,345");
  EXPECT_EQ(tick_text(-1234567.0, 1.0), "\u22121,234,567");
  EXPECT_EQ(tick_text(123.0, 1.0), "123");
}

TEST(PlotPanel, EscapesNamesForXml) {
  EXPECT_EQ(xml_text("a<b>&\"c\"\n"), "a&lt;b&gt;&amp;&quot;c&quot; ");
}

std::string drawn(const PlotPanel& panel) {
  std::ostringstream out;
  ByteSink sink(out, "0");
  write_panel(sink, panel, {10, 20, 100, 50, 0.0, 1.0, true});
  sink.flush();
  return out.str();
}

TEST(PlotPanel, DrawsAStepAsAHorizontalAndAVerticalLine) {
  StepCurve curve(100.0);
  curve.add(40.0, 10.0);
  const std::string svg = drawn({"Holes", "", true, {{&curve, "#000", ""}}});
  EXPECT_NE(svg.find("M10 70H50V"), std::string::npos) << svg;
  EXPECT_NE(svg.find("H110\"/>"), std::string::npos) << svg;
}

TEST(PlotPanel, CountsThatAreManyGetALogarithmicScaleWithAPlaceForZero) {
  StepCurve curve(100.0);
  curve.add(40.0, 12345.0);
  const std::string svg = drawn({"Holes", "", true, {{&curve, "#000", ""}}});
  for (const char* const tick : {">0<", ">1<", ">10<", ">1,000<", ">10,000<", "log scale"}) {
    EXPECT_NE(svg.find(tick), std::string::npos) << tick;
  }
}

TEST(PlotPanel, LargeMeasuresShareAPowerOfTen) {
  StepCurve curve(100.0);
  curve.add(40.0, 2.5e7);
  const std::string svg = drawn({"Volume", "Å³", false, {{&curve, "#000", ""}}});
  EXPECT_NE(svg.find(">7</tspan>"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">2.0<"), std::string::npos) << svg;
}

}  // namespace
}  // namespace orthoball
