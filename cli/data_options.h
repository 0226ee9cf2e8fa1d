// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// Where a command's data goes and in which format, as typed.
struct DataOptions {
  std::string& output;
  std::string& format;  ///< empty: by the name of the output
  bool& json;           ///< --json, the same as --format json
};

/// How --output and --format are told in the help.
struct DataHelp {
  std::string output = "file, or - for standard output";
  std::string format;
  std::vector<std::string> formats;
};

/// Declares -o, --format and --json on a command, in the group Output.
void add_data_options(CLI::App& command, const DataOptions& options, const DataHelp& help);

/// Declares --plot in the group Output.
/// @param what  is drawn.
CLI::Option* add_plot_option(CLI::App& command, std::string& plot, const std::string& what);
/// Declares --plot-axis, which needs that option, in the same group.
void add_plot_axis_option(CLI::App& command, std::string& axis, CLI::Option* plot);
