// SPDX-License-Identifier: MIT
#include "cli/region_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/output/molecule.h"
#include "orthoball/output/region_mesh.h"

namespace {

// "voids of the balls of 1fmo.pdb with a probe of 1.4 at alpha2 0, index 7"
std::string title_of(const Loaded& input, const ChosenBalls& balls, const Regions& regions) {
  const std::string probe =
      balls.probe.nearest > 0.0 ? " with a probe of " + number_text(balls.probe.nearest) : "";
  const std::string file = std::filesystem::path(input.reading.file).filename().string();
  return fmt::format("{}s of the {} of {}{} at {}", regions.name, regions.of, file, probe,
                     orthoball::alpha_text(balls.at.alpha2, balls.at.index));
}

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

template <int D>
void write_region_mesh(const std::string& path, const Loaded& input, const ChosenBalls& balls,
                       const orthoball::Filtration<D>& filtration, const Regions& regions) {
  if (path.empty()) return;
  std::vector<std::span<const orthoball::SimplexId>> cells;
  for (const Region& region : regions.all) cells.push_back(region.cells);
  const auto mesh =
      orthoball::region_mesh<D>(filtration, input.shapes.points(), balls.at.index, cells);
  const bool has_mouths = regions.name != "void";
  std::string title = title_of(input, balls, regions);
  std::replace_if(
      title.begin(), title.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  write_output(path, "", [&](orthoball::ByteSink& sink) {
    write_region_ply(sink, mesh, {title, regions.name, has_mouths});
  });
}

void write_region_script(const std::string& path, const Loaded& input, const ChosenBalls& balls,
                         const orthoball::Filtration<3>& filtration, const Regions& regions) {
  if (path.empty()) return;
  orthoball::ViewerScene scene{
      path_from(path, input.reading.file), title_of(input, balls, regions), regions.name + "s", {}};
  const orthoball::FreeSpace<3> space(filtration, balls.at.index, balls.at.alpha2);
  for (std::size_t i = 0; i < regions.all.size(); ++i) {
    const Region& region = regions.all[i];
    const std::string kind =
        region.kind == regions.name ? std::string() : std::string(region.kind) + ", ";
    orthoball::ShownPart part{fmt::format("{}_{}", regions.name, i + 1),
                              fmt::format("{} {}: {}volume {}, area {}", regions.name, i + 1, kind,
                                          number_text(region.volume), number_text(region.area)),
                              space.empty_balls(region.cells),
                              {}};
    if (region.largest) part.balls.insert(part.balls.begin(), *region.largest);
    for (const orthoball::LiningBall& ball : region.lining) part.atoms.push_back(ball.row);
    scene.parts.push_back(std::move(part));
  }
  const auto viewer = orthoball::viewer_of(ending_of(path)).value();
  write_output(path, "", [&](orthoball::ByteSink& sink) {
    write_viewer_script(sink, viewer, scene, input.reading.labels);
  });
}

template void write_region_mesh(const std::string&, const Loaded&, const ChosenBalls&,
                                const orthoball::Filtration<2>&, const Regions&);
template void write_region_mesh(const std::string&, const Loaded&, const ChosenBalls&,
                                const orthoball::Filtration<3>&, const Regions&);
