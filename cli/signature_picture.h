// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/input_options.h"
#include "orthoball/output/signature_plot.h"

// What commands that draw signatures share.

/// The name of the input without its folders, or "standard input".
[[nodiscard]] std::string name_of(const InputOptions& options);

/// Before any work: a picture is SVG; a name with another ending is a mistake.
/// @param option  what names the file: "-o".
/// @throws UsageError
void require_svg(const std::string& option, const std::string& path);

/// The same of a picture beside other output, which needs a place of its own; empty for none.
/// @throws UsageError
void check_plot(const std::string& option, const std::string& path, const std::string& output,
                const InputOptions& input);

/// What is called alpha, alpha2 or index.
[[nodiscard]] orthoball::PlotAxis plot_axis(const std::string& name);

/// Title and unit of a plot of this input; axis and range are left as they are.
[[nodiscard]] orthoball::PlotOptions plot_options(const InputOptions& options, const Loaded& input);

/// Draws the signatures of all shapes into a file, with the notable alphas marked beside those that
/// `plot` has.
/// @throws orthoball::LimitError where the memory is not enough.
template <int D>
void write_signature_picture(const std::string& path, const InputOptions& options,
                             const orthoball::Filtration<D>& filtration,
                             orthoball::PlotOptions plot);
