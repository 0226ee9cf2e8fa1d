// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/input_options.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"

/// What may stand in a file beside the report.
enum class OutputKind {
  table,   ///< CSV or JSON
  atoms,   ///< PDB
  mesh,    ///< PLY
  script,  ///< of PyMOL or ChimeraX: the name must tell
  cells,   ///< CSV, JSON, VTU or OBJ: the name must tell
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

/// Numbers beyond the double range that were left out, by what stands for them.
struct MissingNumbers {
  std::size_t nulls = 0, empty_fields = 0;
};

/// Writes a table to the output at `path`: JSON where its name ends in .json, else CSV.
/// @throws orthoball::OutputError that names the output and the reason.
void write_table(const std::string& path, MissingNumbers& missing,
                 const std::function<void(orthoball::ByteSink&, orthoball::TableFormat)>& write);
