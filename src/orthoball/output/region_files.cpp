// SPDX-License-Identifier: MIT
#include "orthoball/output/region_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "orthoball/output/alpha_text.h"
#include "orthoball/output/region_mesh.h"
#include "orthoball/output/region_tables.h"
#include "orthoball/queries/free_space.h"

namespace orthoball {
namespace {

std::string number_text(double number) {
  return std::isfinite(number) ? fmt::format("{}", number + 0.0) : "beyond double range";
}

// "voids of the balls of 1fmo.pdb with a probe of 1.4 at alpha2 0, index 7"
std::string title_of(const ShownRegions& regions) {
  const std::string probe =
      regions.probe > 0.0 ? " with a probe of " + number_text(regions.probe) : "";
  return fmt::format("{}s of the {} of {}{} at {}", regions.name, regions.of, regions.source, probe,
                     alpha_text(regions.alpha2, regions.index));
}

}  // namespace

template <int D>
std::vector<ShownRegion> shown_regions(std::span<const Void<D>> voids) {
  std::vector<ShownRegion> shown;
  for (const Void<D>& hole : voids) {
    ShownRegion& region = shown.emplace_back(
        ShownRegion{"void", hole.volume, hole.area, hole.cells, hole.lining, {}});
    if constexpr (D == 3) {
      if (!(hole.largest_ball_radius > 0.0)) continue;
      region.largest = {hole.largest_ball_centre, hole.largest_ball_radius};
    }
  }
  return shown;
}

std::vector<ShownRegion> shown_regions(std::span<const Pocket> pockets) {
  std::vector<ShownRegion> shown;
  for (const Pocket& pocket : pockets) {
    shown.push_back(
        {pocket_kind(pocket), pocket.volume, pocket.area, pocket.cells, pocket.lining, {}});
  }
  return shown;
}

template <int D>
void write_regions_mesh(ByteSink& sink, const Filtration<D>& filtration,
                        const WeightedPoints& points, const ShownRegions& regions) {
  std::vector<std::span<const SimplexId>> cells;
  for (const ShownRegion& region : regions.all) cells.push_back(region.cells);
  const RegionMesh<D> mesh = region_mesh<D>(filtration, points, regions.index, cells);
  const bool has_mouths = regions.name != "void";
  std::string title = title_of(regions);
  std::replace_if(
      title.begin(), title.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  write_region_ply(sink, mesh, {title, regions.name, has_mouths});
}

void write_regions_script(ByteSink& sink, Viewer viewer, const Filtration<3>& filtration,
                          const ShownRegions& regions, const std::string& file,
                          const SiteLabels& labels) {
  ViewerScene scene{file, title_of(regions), regions.name + "s", {}};
  const FreeSpace<3> space(filtration, regions.index, regions.alpha2);
  for (std::size_t i = 0; i < regions.all.size(); ++i) {
    const ShownRegion& region = regions.all[i];
    const std::string kind =
        region.kind == regions.name ? std::string() : std::string(region.kind) + ", ";
    ShownPart part{fmt::format("{}_{}", regions.name, i + 1),
                   fmt::format("{} {}: {}volume {}, area {}", regions.name, i + 1, kind,
                               number_text(region.volume), number_text(region.area)),
                   space.empty_balls(region.cells),
                   {}};
    if (region.largest) part.balls.insert(part.balls.begin(), *region.largest);
    for (const LiningBall& ball : region.lining) part.atoms.push_back(ball.row);
    scene.parts.push_back(std::move(part));
  }
  write_viewer_script(sink, viewer, scene, labels);
}

template std::vector<ShownRegion> shown_regions<2>(std::span<const Void<2>>);
template std::vector<ShownRegion> shown_regions<3>(std::span<const Void<3>>);
template void write_regions_mesh<2>(ByteSink&, const Filtration<2>&, const WeightedPoints&,
                                    const ShownRegions&);
template void write_regions_mesh<3>(ByteSink&, const Filtration<3>&, const WeightedPoints&,
                                    const ShownRegions&);

}  // namespace orthoball
