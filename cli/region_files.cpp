// SPDX-License-Identifier: MIT
#include "cli/region_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "cli/output_file.h"
#include "cli/usage_error.h"
#include "orthoball/output/molecule.h"

namespace {

// The input as it is found from the folder of the script.
std::string path_from(const std::string& script, const std::string& input) {
  if (script == "-" || std::filesystem::path(input).is_absolute()) return input;
  std::error_code error;  // then the path is empty
  const auto folder = std::filesystem::absolute(script, error).parent_path();
  const std::string path = std::filesystem::proximate(input, folder, error).string();
  return path.empty() ? input : path;
}

}  // namespace

void check_script(const std::string& path, const orthoball::Reading& reading) {
  if (path.empty()) return;
  constexpr std::array<std::string_view, 4> kOpened{"pdb", "cif", "pqr", "xyz"};
  const bool is_opened = std::count(kOpened.begin(), kOpened.end(), reading.format) > 0;
  if (reading.file == "-" || !is_opened || reading.points.dimension() != 3) {
    throw UsageError(fmt::format(
        "--script: the viewer opens the input itself, which must be a PDB, mmCIF, PQR or XYZ file; "
        "--mesh writes a mesh of any input"));
  }
}

orthoball::ShownRegions regions_of(const Loaded& input, const ChosenBalls& balls,
                                   const std::string& name, const std::string& of) {
  return {name,
          of,
          std::filesystem::path(input.reading.file).filename().string(),
          balls.probe.nearest,
          balls.at.index,
          balls.at.alpha2,
          {}};
}

template <int D>
void write_region_mesh(const std::string& path, const Loaded& input,
                       const orthoball::Filtration<D>& filtration,
                       const orthoball::ShownRegions& regions) {
  if (path.empty()) return;
  write_output(path, "", [&](orthoball::ByteSink& sink) {
    write_regions_mesh<D>(sink, filtration, input.shapes.points(), regions);
  });
}

void write_region_script(const std::string& path, const Loaded& input,
                         const orthoball::Filtration<3>& filtration,
                         const orthoball::ShownRegions& regions) {
  if (path.empty()) return;
  const auto viewer = orthoball::viewer_of(ending_of(path)).value();
  write_output(path, "", [&](orthoball::ByteSink& sink) {
    write_regions_script(sink, viewer, filtration, regions, path_from(path, input.reading.file),
                         input.reading.labels);
  });
}

template void write_region_mesh(const std::string&, const Loaded&, const orthoball::Filtration<2>&,
                                const orthoball::ShownRegions&);
template void write_region_mesh(const std::string&, const Loaded&, const orthoball::Filtration<3>&,
                                const orthoball::ShownRegions&);
