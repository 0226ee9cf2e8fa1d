// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "orthoball/output/byte_sink.h"
#include "orthoball/output/step_curve.h"

namespace orthoball {

/// Multiples of 1, 2 or 5 times a power of ten within [low, high], about `wanted` of them; at least
/// one if low < high. Display only.
[[nodiscard]] std::vector<double> tick_values(double low, double high, int wanted);

/// A tick's number: as many decimals as a step of `step` needs, commas between thousands.
[[nodiscard]] std::string tick_text(double value, double step);

/// One curve of a panel.
struct PlotCurve {
  const StepCurve* curve;
  std::string colour;  ///< "#0072b2"
  std::string name;    ///< for the legend; empty in a panel of one curve
};

/// One diagram of a plot.
struct PlotPanel {
  std::string title;
  std::string unit;               ///< behind the title; may be empty
  bool is_count = false;          ///< whole numbers, on a logarithmic scale where they are many
  std::vector<PlotCurve> curves;  ///< drawn in this order
};

/// Where a panel's drawing area lies, in pixels, and its horizontal axis.
struct PlotFrame {
  double left, top, width, height;
  double from, to;   ///< values at the left and right edge
  bool has_numbers;  ///< below the horizontal axis
  bool is_whole;     ///< that axis has ticks at whole numbers only, perhaps none
};

/// Draws frame, grid, axes, curves and legend.
void write_panel(ByteSink& sink, const PlotPanel& panel, const PlotFrame& frame);

}  // namespace orthoball
