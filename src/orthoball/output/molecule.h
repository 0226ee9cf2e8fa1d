// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/ids.h"
#include "orthoball/input/site_labels.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/queries/inscribed_ball.h"

namespace orthoball {

/// What a PDB file could not hold as it is.
struct PdbLosses {
  std::size_t values = 0;  ///< below -99.99 or above 999.99, not finite: the nearest is written
  std::size_t labels = 0;  ///< names and numbers that are longer than their columns: cut
};

/// Before writing a PDB file.
/// @throws LimitError that names the row for coordinates that its columns do not hold, which go
///         from -999.999 to 9999.999, and for more than 87,440,031 points.
void require_pdb_points(const WeightedPoints& points);

/// A PDB file with one ATOM record a row, in their order: names as far as labels tell them,
/// otherwise atom and element X in residue UNK 1 without a chain; coordinates with 3 decimals,
/// occupancy 1.00, and a value of each row in the column of the B-factor.
///
/// Serial numbers above 99999 and residue numbers above 9999 are written as hybrid-36, which counts
/// on with letters (A0000). Chain names of two characters take the blank before them too.
/// @param values  [row]
/// @throws LimitError as require_pdb_points, before anything is written.
PdbLosses write_pdb(ByteSink& sink, const WeightedPoints& points, const SiteLabels& labels,
                    std::span<const double> values);

/// Programs that show molecules, told by the ending of a script.
enum class Viewer {
  pymol,     ///< .pml
  chimerax,  ///< .cxc
};

/// "pml" or "cxc"; empty for others.
[[nodiscard]] std::optional<Viewer> viewer_of(std::string_view ending);

/// A void or pocket as a viewer shows it.
struct ShownPart {
  std::string name;                       ///< an identifier: "void_1"
  std::string title;                      ///< one line about it
  std::vector<InscribedBall<3>> balls{};  ///< [ball] in input units
  std::vector<SiteId> atoms{};            ///< rows around it, ascending
};

/// What a script shows: a file's molecule and parts of it.
struct ViewerScene {
  std::string file;                ///< from the folder of the script
  std::string title;               ///< one line
  std::string group;               ///< an identifier for all parts: "voids"
  std::vector<ShownPart> parts{};  ///< [part] in the order of their colours
};

/// A script that opens the file and shows every part as spheres of a colour, an object of its own
/// (ChimeraX: a set of markers), with the atoms around it as a selection NAME_atoms by chain,
/// residue and atom name. There are no selections where labels name no atoms or residues.
void write_viewer_script(ByteSink& sink, Viewer viewer, const ViewerScene& scene,
                         const SiteLabels& labels);

}  // namespace orthoball
