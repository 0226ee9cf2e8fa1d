// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/balls.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/queries/free_space.h"
#include "orthoball/queries/inscribed_ball.h"

// The files that show voids or pockets: --mesh and --script.

/// A void or pocket.
struct Region {
  std::string_view kind;  ///< "void", "pocket", "channel"
  double volume;
  double area;
  std::span<const orthoball::SimplexId> cells;
  std::span<const orthoball::LiningBall> lining;
  std::optional<orthoball::InscribedBall<3>> largest{};  ///< the largest ball inside, if known
};

/// Those of an input.
struct Regions {
  std::string name;          ///< what one is called: "void" or "pocket"
  std::string of = "balls";  ///< of what of the input
  std::vector<Region> all{};
};

/// Before any work on what was read; nothing where `path` is empty.
/// @throws UsageError for an input that is no molecule which a viewer opens by its name.
void check_script(const std::string& path, const orthoball::Reading& reading);

/// Writes the boundary of every region to `path`, if that is not empty.
template <int D>
void write_region_mesh(const std::string& path, const Loaded& input, const ChosenBalls& balls,
                       const orthoball::Filtration<D>& filtration, const Regions& regions);

/// Writes the script that shows every region to `path`, if that is not empty.
void write_region_script(const std::string& path, const Loaded& input, const ChosenBalls& balls,
                         const orthoball::Filtration<3>& filtration, const Regions& regions);

extern template void write_region_mesh(const std::string&, const Loaded&, const ChosenBalls&,
                                       const orthoball::Filtration<2>&,
                                       const Regions&);  // in region_files.cpp
extern template void write_region_mesh(const std::string&, const Loaded&, const ChosenBalls&,
                                       const orthoball::Filtration<3>&, const Regions&);
