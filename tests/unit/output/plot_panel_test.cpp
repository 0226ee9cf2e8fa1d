// SPDX-License-Identifier: MIT
#include "orthoball/output/plot_panel.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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

std::string drawn(const PlotPanel& panel,
                  const PlotFrame& frame = {10, 20, 100, 50, 0.0, 1.0, true, false}) {
  std::ostringstream out;
  ByteSink sink(out, "0");
  write_panel(sink, panel, frame);
  sink.flush();
  return out.str();
}

// The x of the numbers below the horizontal axis, and the y of those beside the vertical one.
std::vector<double> places(const std::string& svg, const std::string& axis) {
  const std::regex label(axis == "x" ? R"re(<text x="([-.\d]+)" y="[-.\d]+" text-anchor="middle")re"
                                     : R"re(<text x="3" y="([-.\d]+)" text-anchor="end")re");
  std::vector<double> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), label), end; at != end; ++at) {
    found.push_back(std::stod((*at)[1]));
  }
  return found;
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

TEST(PlotPanel, NumbersOfTheHorizontalAxisDoNotRunTogether) {
  StepCurve curve(390.0);
  for (const auto& [from, to] :
       {std::pair(0.0, 430000.0), std::pair(1e9, 1e9 + 1), std::pair(0.0, 1.0)}) {
    const std::string svg = drawn({"Holes", "", true, {{&curve, "#000", ""}}},
                                  {10, 20, 390, 150, from, to, true, false});
    const std::vector<double> at = places(svg, "x");
    ASSERT_GE(at.size(), 2U) << svg;
    const double widest = 6.0 * static_cast<double>(tick_text(to, (to - from) / 10).size());
    for (std::size_t i = 1; i < at.size(); ++i) EXPECT_GE(at[i] - at[i - 1], widest) << from;
  }
}

TEST(PlotPanel, AnAxisOfWholeNumbersHasNoTicksBetweenThem) {
  StepCurve curve(390.0);
  const std::string svg =
      drawn({"Holes", "", true, {{&curve, "#000", ""}}}, {10, 20, 390, 150, 1.0, 2.0, true, true});
  EXPECT_EQ(places(svg, "x"), (std::vector<double>{10, 400}));
  const auto between = [&](double from, double to) {
    return drawn({"Holes", "", true, {{&curve, "#000", ""}}},
                 {10, 20, 400, 150, from, to, true, true});
  };
  EXPECT_TRUE(places(between(1.2, 1.6), "x").empty());
  EXPECT_EQ(places(between(1.5, 2.5), "x"), std::vector<double>{210});
  EXPECT_NE(between(1.5, 2.5).find(">2<"), std::string::npos);
}

TEST(PlotPanel, NumbersOfALogarithmicScaleDoNotLieOnEachOther) {
  for (const double high : {100.0, 1e5, 1e7}) {
    StepCurve curve(390.0);
    curve.add(40.0, high);
    const std::string svg = drawn({"Holes", "", true, {{&curve, "#000", ""}}},
                                  {10, 20, 390, 150, 0.0, 1.0, false, false});
    const std::vector<double> at = places(svg, "y");
    ASSERT_GE(at.size(), 4U);
    for (std::size_t i = 1; i < at.size(); ++i) EXPECT_GE(at[i - 1] - at[i], 9.0) << high;
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
