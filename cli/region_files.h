// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/balls.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/output/region_files.h"

// The files that show voids or pockets: --mesh and --script.

/// None yet, of an input.
/// @param name  what one is called: "void" or "pocket".
/// @param of    "balls" or "shape".
[[nodiscard]] orthoball::ShownRegions regions_of(const Loaded& input, const ChosenBalls& balls,
                                                 const std::string& name, const std::string& of);

/// Before any work on what was read; nothing where `path` is empty.
/// @throws UsageError for an input that is no molecule which a viewer opens by its name.
void check_script(const std::string& path, const orthoball::Reading& reading);

/// Writes the boundary of every region to `path`, if that is not empty.
template <int D>
void write_region_mesh(const std::string& path, const Loaded& input,
                       const orthoball::Filtration<D>& filtration,
                       const orthoball::ShownRegions& regions);

/// Writes the script that shows every region to `path`, if that is not empty.
void write_region_script(const std::string& path, const Loaded& input,
                         const orthoball::Filtration<3>& filtration,
                         const orthoball::ShownRegions& regions);

extern template void write_region_mesh(const std::string&, const Loaded&,
                                       const orthoball::Filtration<2>&,
                                       const orthoball::ShownRegions&);  // in region_files.cpp
extern template void write_region_mesh(const std::string&, const Loaded&,
                                       const orthoball::Filtration<3>&,
                                       const orthoball::ShownRegions&);
