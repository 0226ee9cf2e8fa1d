// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "orthoball/output/signature_plot.h"
#include "python/module.h"

/// What runs along the horizontal axis of a plot, by name.
[[nodiscard]] inline orthoball::PlotAxis plot_axis(const std::string& name) {
  if (name == "alpha") return orthoball::PlotAxis::alpha;
  if (name == "alpha2") return orthoball::PlotAxis::alpha2;
  if (name == "index") return orthoball::PlotAxis::index;
  refuse("the axis is \"" + name + "\"; it is \"alpha\", \"alpha2\" or \"index\"");
}
