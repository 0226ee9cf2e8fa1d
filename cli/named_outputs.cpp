// SPDX-License-Identifier: MIT
#include "cli/named_outputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/output_file.h"
#include "cli/usage_error.h"

namespace {

struct Kind {
  const char* what;
  std::vector<std::string> endings;
  bool needs_ending;
};

Kind kind_of(OutputKind kind) {
  switch (kind) {
    case OutputKind::table:
      return {"the table is CSV or JSON", {"csv", "json"}, false};
    case OutputKind::atoms:
      return {"the atoms are PDB", {"pdb", "ent"}, false};
    case OutputKind::mesh:
      return {"the mesh is PLY", {"ply"}, false};
    case OutputKind::script:
      return {"the script is for PyMOL or ChimeraX", {"pml", "cxc"}, true};
    case OutputKind::cells:
      break;
  }
  return {"the power cells are CSV, JSON, VTU or OBJ", {"csv", "json", "vtu", "obj"}, true};
}

void check_ending(const NamedOutput& output) {
  const Kind kind = kind_of(output.kind);
  const std::string ending = output.path == "-" ? "" : ending_of(output.path);
  if (ending.empty() && !kind.needs_ending) return;
  if (std::count(kind.endings.begin(), kind.endings.end(), ending) > 0) return;
  throw UsageError(fmt::format("{} {}: {}; the name must end in .{}", output.option, output.path,
                               kind.what, fmt::join(kind.endings, " or .")));
}

}  // namespace

void check_outputs(const InputOptions& input, const std::string& report,
                   const std::vector<NamedOutput>& outputs) {
  require_other_file(input, report);
  std::vector<NamedOutput> seen{{"-o", report, {}}};
  for (const NamedOutput& output : outputs) {
    const auto& [option, path, kind] = output;
    if (path.empty()) continue;
    require_other_file(input, path);
    for (const NamedOutput& other : seen) {
      if (!is_same_output(path, other.path)) continue;
      throw UsageError(path == "-" && other.option == "-o"
                           ? option + " -: the report goes to standard output; it needs -o FILE"
                           : other.option + " and " + option +
                                 " name the same file; each needs one of its own");
    }
    check_ending(output);
    seen.push_back(output);
  }
}

void write_table(const std::string& path, MissingNumbers& missing,
                 const std::function<void(orthoball::ByteSink&, orthoball::TableFormat)>& write) {
  using orthoball::TableFormat;
  const auto format = ending_of(path) == "json" ? TableFormat::json : TableFormat::csv;
  const bool is_json = format == TableFormat::json;
  (is_json ? missing.nulls : missing.empty_fields) += write_output(
      path, is_json ? "null" : "", [&](orthoball::ByteSink& sink) { write(sink, format); });
}
