// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "orthoball/input/site_labels.h"
#include "orthoball/memory_budget.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// Which atoms of a molecule are taken.
struct MoleculeOptions {
  std::optional<int> model{};  ///< model number of the file; empty: the first one
  std::string altloc{};        ///< one alternate's letter; empty: highest occupancy, then first
  bool hydrogens = true;       ///< keep hydrogen and deuterium
  bool ligands = true;         ///< keep hetero atoms that are not water
  bool waters = false;         ///< keep HOH, WAT, DOD, TIP3, SOL, ...
  std::vector<std::string> chains{};  ///< keep these only; empty: all
  friend bool operator==(const MoleculeOptions&, const MoleculeOptions&) = default;
};

/// How a file is to be read; each default is what its name and content suggest.
struct ReadOptions {
  std::string format{};                ///< a name of input_formats(); empty: from the file name
  std::optional<int> dimension{};      ///< 2 or 3; empty: as the file suggests
  std::vector<std::string> columns{};  ///< coordinate columns: 1-based numbers or names
  std::string radius_column{};         ///< 1-based number or name; empty: none
  std::string weight_column{};         ///< as above; excludes radius_column
  std::string radii{};                 ///< bondi, alvarez, protor, none, or a file's path; empty:
                                       ///< the radii in a molecule's file, else bondi
  bool only_points = false;            ///< atoms are points: radii none, in any format
  std::optional<std::string> default_radius{};  ///< a decimal, for elements without a radius
  MoleculeOptions molecule{};
  bool allow_empty = false;  ///< a file without any site is no error
  bool limited = true;       ///< refuse inputs over 1 GiB or compressed by more than 200
  MemoryBudget memory{};     ///< by default what the system has
};

/// What a file gave.
struct Reading {
  WeightedPoints points;
  SiteLabels labels{};
  std::string file{};        ///< the path as given
  std::string format{};      ///< the format it was read as, one of input_formats()
  std::string radii{};       ///< where weights come from, in words: "bondi (Bondi 1964; ...)",
                             ///< "column 4", "the file's own", "none"
  bool is_molecule = false;  ///< weights are squared radii of a molecule's atoms
  std::vector<std::string> notes{};     ///< choices made: models, alternates, waters, first block
  std::vector<std::string> warnings{};  ///< things the user should look at
};

/// Reads weighted points from a file, the format told by its name (a trailing .gz put aside) unless
/// `options.format` names it; standard input for "-", which needs `options.format`.
/// @throws ParseError `FILE:LINE: what is wrong; what would be right` for a file that is not what
///         its format says, that has no site (unless allowed), or cannot be opened.
/// @throws InputError for options that do not fit each other or the format.
/// @throws LimitError for a file that is too large for `options.memory`.
[[nodiscard]] Reading read(const std::string& path, const ReadOptions& options);

/// Names of the formats `read` knows, for `--input-format`.
[[nodiscard]] const std::vector<std::string>& input_formats();

}  // namespace orthoball
