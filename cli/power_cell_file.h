// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>

#include "cli/balls.h"
#include "cli/named_outputs.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/union_of_balls.h"

// The file of power cells: --cells and what goes with it.

/// As typed.
struct PowerCellFile {
  std::string path;            ///< empty: not wanted
  std::string within = "box";  ///< or "balls"
  std::string box;             ///< empty: around all balls
  std::string tolerance = "0.02";

  [[nodiscard]] bool is_within_balls() const { return !path.empty() && within == "balls"; }
};

/// Declares the options on a command, in the group of its outputs.
void add_power_cell_options(CLI::App& command, PowerCellFile& file, const std::string& group);

/// Before any work on what was read; nothing where no file is wanted.
/// @throws UsageError for a box or tolerance that is none, or of another dimension.
void check_power_cells(const PowerCellFile& file, int dimension);

/// Writes the file, if it is wanted, and says which box it was.
/// @param balls  with contacts, where is_within_balls().
/// @param missing  counts numbers that were not finite.
template <int D>
void write_power_cells(const PowerCellFile& file, const InputOptions& options, const Loaded& input,
                       const ChosenBalls& chosen, const orthoball::Filtration<D>& filtration,
                       const orthoball::UnionOfBalls& balls, MissingNumbers& missing);

extern template void write_power_cells<2>(const PowerCellFile&, const InputOptions&, const Loaded&,
                                          const ChosenBalls&, const orthoball::Filtration<2>&,
                                          const orthoball::UnionOfBalls&, MissingNumbers&);
extern template void write_power_cells<3>(const PowerCellFile&, const InputOptions&, const Loaded&,
                                          const ChosenBalls&, const orthoball::Filtration<3>&,
                                          const orthoball::UnionOfBalls&, MissingNumbers&);
