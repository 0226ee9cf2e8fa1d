// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
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
  std::optional<unsigned> threads;            // an upper bound; none: one for each core
  std::optional<std::uint64_t> memory_limit;  // bytes; none: what the system has

  std::optional<std::uint32_t> density_neighbours;  // of --weights density:K; none: as read

  // As typed, made into `read` by load().
  std::string columns, chains, default_radius, hydrogens = "keep", ligands = "keep",
                                               waters = "drop";
  bool no_limit = false;
};

/// Refuses a value that is no whole number from `least` to `most`, in words.
[[nodiscard]] CLI::Validator whole_number(std::uint32_t least, std::uint32_t most);

/// Declares INPUT and these options on a command.
void add_input_options(CLI::App& command, InputOptions& options);

/// An input that was read, and everything known of its shapes.
struct Loaded {
  orthoball::Reading reading;  ///< its points have moved into `shapes`
  orthoball::AlphaShapes shapes;
  orthoball::Threads threads{};      ///< for what is asked of the shapes
  orthoball::MemoryBudget memory{};  ///< for the same

  /// "Å" for molecules, otherwise empty: the unit of the input is not known.
  [[nodiscard]] std::string unit() const { return reading.is_molecule ? "Å" : ""; }
};

/// Before any work: an output must not take the place of the input or of a file of radii.
/// @throws UsageError
void require_other_file(const InputOptions& options, const std::string& output);

/// What --threads and --memory-limit allow.
[[nodiscard]] orthoball::Threads threads_of(const InputOptions& options);
[[nodiscard]] orthoball::MemoryBudget memory_of(const InputOptions& options);

/// Reads the input; says on standard error which radii were taken and what the reader noted.
/// @throws orthoball::LimitError where the memory is not enough.
/// @param says_notes  false for commands that print them among their data.
[[nodiscard]] orthoball::Reading read_input(const InputOptions& options, Progress& progress,
                                            bool says_notes = true);

/// Builds the shapes of what was read.
/// @throws orthoball::LimitError where the memory is not enough.
[[nodiscard]] Loaded build_shapes(const InputOptions& options, Progress& progress,
                                  orthoball::Reading reading);

/// Both.
[[nodiscard]] Loaded load(const InputOptions& options, Progress& progress, bool says_notes = true);

/// Before work on an input that takes `bytes` more.
/// @throws orthoball::LimitError that names the input and `work` where the memory is not enough.
void require_memory(const InputOptions& options, std::uint64_t bytes, const std::string& work);

/// One line on standard error, unless --quiet: "orthoball: TEXT".
void say(const InputOptions& options, const std::string& text);

/// Says that `count` numbers are beyond the double range and stand as `shown`; nothing for 0.
void warn_of_missing(const InputOptions& options, std::size_t count, const std::string& shown);
