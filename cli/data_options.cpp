// SPDX-License-Identifier: MIT
#include "cli/data_options.h"

void add_data_options(CLI::App& command, const DataOptions& options, const DataHelp& help) {
  const std::string group = "Output";
  command.add_option("-o,--output", options.output, help.output)
      ->type_name("FILE")
      ->capture_default_str()
      ->group(group);
  auto* const format = command.add_option("--format", options.format, help.format)
                           ->type_name("NAME")
                           ->check(CLI::IsMember(help.formats).description(""))
                           ->group(group);
  command.add_flag("--json", options.json, "the same as --format json")
      ->excludes(format)
      ->group(group);
}

CLI::Option* add_plot_option(CLI::App& command, std::string& plot, const std::string& what) {
  return command.add_option("--plot", plot, "also draw " + what + " as SVG into this file")
      ->type_name("FILE")
      ->group("Output");
}

void add_plot_axis_option(CLI::App& command, std::string& axis, CLI::Option* plot) {
  command.add_option("--plot-axis", axis, "what runs along the plot: alpha, alpha2 or index")
      ->type_name("NAME")
      ->check(CLI::IsMember({"alpha", "alpha2", "index"}).description(""))
      ->capture_default_str()
      ->needs(plot)
      ->group("Output");
}
