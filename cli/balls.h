// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "cli/alpha_options.h"
#include "cli/input_options.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/points/probe.h"
#include "orthoball/queries/free_space.h"

// What commands about unions of balls share: which balls, grown by which probe, at which alpha.

/// The input, the probe as typed, and the alpha: one value, 0 unless given.
struct BallsOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::string probe = "0";
};

/// The balls that were chosen.
struct ChosenBalls {
  ChosenAlpha at;
  orthoball::ProbeRadius probe;
};

/// Declares --probe and the forms of alpha on a command; INPUT and how to read it is left to
/// add_input_options.
void add_balls_options(CLI::App& command, BallsOptions& options);

/// Before any work.
/// @throws UsageError for a probe that is no radius and an alpha that is none.
[[nodiscard]] orthoball::ProbeRadius checked_probe(const BallsOptions& options);

/// What was read, as the balls that the probe's centre rolls around.
/// @throws orthoball::ParseError that names the line of an imaginary ball.
[[nodiscard]] orthoball::Reading with_probe(orthoball::Reading reading,
                                            const orthoball::ProbeRadius& probe);

/// The alpha that was asked for, otherwise 0: the balls as they are.
[[nodiscard]] ChosenAlpha chosen_alpha(const BallsOptions& options, const Loaded& input);

/// The lines that say what was read, the probe, and the alpha.
[[nodiscard]] std::string balls_text(const Loaded& input, const ChosenBalls& balls);

/// The keys `input`, `dimension`, `name`, `alpha2`, `alpha`, `index`, `probe`.
/// @param missing  counts numbers beyond the double range, which are null.
[[nodiscard]] nlohmann::ordered_json balls_json(const Loaded& input, const ChosenBalls& balls,
                                                std::size_t& missing);

/// Adds the keys `atoms` (rows), `atom_names` and `atom_areas` of the balls around a void or
/// pocket.
/// @param has_areas  otherwise `atom_areas` is null.
void add_lining(nlohmann::ordered_json& json, std::span<const orthoball::LiningBall> lining,
                bool has_areas, const Loaded& input, std::size_t& missing);

/// The names of rows, such as "A/ALA 12/CB"; null where the input has none.
[[nodiscard]] nlohmann::ordered_json names_json(std::span<const orthoball::SiteId> rows,
                                                const Loaded& input);

// Peaks of memory beyond the filtration, in bytes. The constants are peaks of the resident memory
// (VmHWM, reset before each work) of the families of benchmarks `atoms` at alpha2 0 and `uniform`
// where it has most voids, with 100,000 to 1,000,000 sites.

/// Bytes that molecular_surface takes at an index, beyond the union.
[[nodiscard]] std::uint64_t molecular_memory(const orthoball::Filtration<3>& filtration,
                                             std::uint32_t index);

/// What of a union of balls is measured.
struct UnionWork {
  int dimension;
  std::size_t sites;
  std::size_t contacts;  ///< at most so many; 0 where they are not wanted
  bool derivatives;
};
/// Of measuring a union of balls, and then its voids.
[[nodiscard]] std::uint64_t union_memory(const UnionWork& work);
/// Of finding pockets among so many cells.
[[nodiscard]] std::uint64_t pockets_memory(int dimension, std::size_t cells);

/// Of a report in JSON that lists so many balls around voids or pockets, by name where labels have
/// names.
[[nodiscard]] std::uint64_t report_memory(std::size_t balls, const Loaded& input);

/// Warns if there are points but not one ball with an inside.
void warn_without_balls(const InputOptions& options, const Loaded& input, double alpha2);
