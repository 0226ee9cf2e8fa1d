// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/input_options.h"

/// What may stand in a file beside the report.
enum class OutputKind {
  table,   ///< CSV
  atoms,   ///< PDB
  mesh,    ///< PLY
  script,  ///< of PyMOL or ChimeraX: the name must tell
};

/// A file beside the report, and the option that names it.
struct NamedOutput {
  std::string option;
  std::string path;  ///< empty: not wanted
  OutputKind kind = OutputKind::table;
};

/// Before any work: every output needs a place of its own and a name with the ending of its kind.
/// @param report  where the report goes.
/// @throws UsageError
void check_outputs(const InputOptions& input, const std::string& report,
                   const std::vector<NamedOutput>& outputs);
