// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/input/site_labels.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/molecule.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/queries/inscribed_ball.h"
#include "orthoball/queries/pockets.h"
#include "orthoball/queries/voids.h"

namespace orthoball {

/// A void or pocket that a file shows. Refers to what it was made of.
struct ShownRegion {
  std::string_view kind;                      ///< "void", "pocket", "channel"
  double volume = 0.0;                        ///< length^D
  double area = 0.0;                          ///< length^(D-1)
  std::span<const SimplexId> cells{};         ///< outside the complex
  std::span<const LiningBall> lining{};       ///< the balls around it
  std::optional<InscribedBall<3>> largest{};  ///< the largest ball inside, if known
};

/// The voids or pockets of a union of balls, and of what that is made.
struct ShownRegions {
  std::string name;                ///< what one is called: "void" or "pocket"
  std::string of;                  ///< of what of the input: "balls", "shape"
  std::string source;              ///< its name, without folders
  double probe = 0.0;              ///< radius that all radii have grown by; length
  std::uint32_t index = 0;         ///< of the complex
  double alpha2 = 0.0;             ///< length^2
  std::vector<ShownRegion> all{};  ///< numbered from 1 in this order
};

/// Without what they are of.
template <int D>
[[nodiscard]] std::vector<ShownRegion> shown_regions(std::span<const Void<D>> voids);
[[nodiscard]] std::vector<ShownRegion> shown_regions(std::span<const Pocket> pockets);

/// The boundaries of all regions as a binary PLY, see write_region_ply.
/// @param points  what the filtration was made of.
/// @throws OutputError
template <int D>
void write_regions_mesh(ByteSink& sink, const Filtration<D>& filtration,
                        const WeightedPoints& points, const ShownRegions& regions);

/// A script in which a viewer shows the space of every region as spheres, see write_viewer_script.
/// @param file  the molecule, from the folder of the script.
/// @throws OutputError
void write_regions_script(ByteSink& sink, Viewer viewer, const Filtration<3>& filtration,
                          const ShownRegions& regions, const std::string& file,
                          const SiteLabels& labels);

extern template std::vector<ShownRegion> shown_regions<2>(std::span<const Void<2>>);
extern template std::vector<ShownRegion> shown_regions<3>(
    std::span<const Void<3>>);  // in region_files.cpp
extern template void write_regions_mesh<2>(ByteSink&, const Filtration<2>&, const WeightedPoints&,
                                           const ShownRegions&);
extern template void write_regions_mesh<3>(ByteSink&, const Filtration<3>&, const WeightedPoints&,
                                           const ShownRegions&);

}  // namespace orthoball
