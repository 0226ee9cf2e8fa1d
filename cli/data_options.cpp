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
