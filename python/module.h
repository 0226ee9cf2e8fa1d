// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "orthoball/alpha_shapes.h"
#include "orthoball/error.h"
#include "orthoball/parallel.h"
#include "orthoball/signatures/notable_alphas.h"

// What each file binds, in the order in which later ones need earlier ones.
void bind_errors(nanobind::module_& module);
void bind_reading(nanobind::module_& module);
void bind_alpha_shapes(nanobind::module_& module);
void bind_weights(nanobind::module_& module);
void bind_simplices(nanobind::module_& module);
void bind_topology(nanobind::module_& module);
void bind_signatures(nanobind::module_& module);
void bind_alpha_candidates(nanobind::module_& module);
void bind_shape(nanobind::module_& module);
void bind_manifold(nanobind::module_& module);
void bind_balls(nanobind::module_& module);
void bind_ball_files(nanobind::module_& module);
void bind_free_space(nanobind::module_& module);
void bind_queries(nanobind::module_& module);
void bind_power_cells(nanobind::module_& module);
void bind_view(nanobind::module_& module);

/// Throws an InputError without a row.
[[noreturn]] inline void refuse(const std::string& message) {
  using orthoball::InputError;
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow, message);
}

/// At most so many, or one for each core.
[[nodiscard]] inline orthoball::Threads threads_of(std::optional<unsigned> threads) {
  return threads ? orthoball::Threads(*threads) : orthoball::Threads();
}

/// A message of the library, which tells what would be right by the options of the program, with
/// what Python calls them.
[[nodiscard]] std::string in_python(std::string message);  // in bind_errors.cpp

/// Where the weights of some shapes come from.
[[nodiscard]] inline orthoball::WeightMeaning meaning_of_weights(
    const orthoball::AlphaShapes& shapes, bool is_molecule) {
  using orthoball::WeightMeaning;
  if (is_molecule) return WeightMeaning::molecule_radii;
  const bool has_weights = shapes.points().weight_kind() != orthoball::WeightKind::none;
  return has_weights ? WeightMeaning::given : WeightMeaning::none;
}

/// Calls `visit` with the Filtration<D> of `shapes` while other Python threads run. It must not
/// touch Python.
template <class Visit>
auto without_gil(const orthoball::AlphaShapes& shapes, const Visit& visit) {
  const nanobind::gil_scoped_release released;
  return std::visit(visit, shapes.filtration());
}
