// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/progress.h"
#include "orthoball/alpha_shapes.h"
#include "orthoball/input/read.h"

/// What every command takes: the input, how to read it, and what to say meanwhile.
struct InputOptions {
  std::string path;
  orthoball::ReadOptions read;
  ProgressMode progress = ProgressMode::automatic;
  bool quiet = false;
  unsigned threads = 1;  // an upper bound

  // As typed, made into `read` by load().
  std::string columns, chains, default_radius, hydrogens = "keep", ligands = "keep",
                                               waters = "drop";
  bool no_limit = false;
};

/// Declares INPUT and these options on a command.
void add_input_options(CLI::App& command, InputOptions& options);

/// An input that was read, and everything known of its shapes.
struct Loaded {
  orthoball::Reading reading;  ///< its points have moved into `shapes`
  orthoball::AlphaShapes shapes;

  /// "Å" for molecules, otherwise empty: the unit of the input is not known.
  [[nodiscard]] std::string unit() const { return reading.is_molecule ? "Å" : ""; }
};

/// Reads the input and builds its shapes; says on standard error which radii were taken and what
/// the reader noted.
/// @param says_notes  false for commands that print them among their data.
[[nodiscard]] Loaded load(const InputOptions& options, Progress& progress, bool says_notes = true);

/// One line on standard error, unless --quiet: "orthoball: TEXT".
void say(const InputOptions& options, const std::string& text);

/// Says that `count` numbers are beyond the double range and stand as `shown`; nothing for 0.
void warn_of_missing(const InputOptions& options, std::size_t count, const std::string& shown);
