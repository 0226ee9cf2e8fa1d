// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "orthoball/queries/edited_shape.h"

/// Which parts of a shape are kept and which of its holes are filled, as typed.
struct EditOptions {
  std::uint32_t region = 0;  ///< 0: all
  std::string region_threshold, hole_threshold;
  bool regularized = false;

  [[nodiscard]] bool are_given() const {
    return region > 0 || !region_threshold.empty() || !hole_threshold.empty();
  }
};

/// Declares --region, --region-threshold, --hole-threshold and --regularized on a command.
void add_edit_options(CLI::App& command, EditOptions& options);

/// What was typed.
/// @throws UsageError for a threshold that is no number from 0 on.
[[nodiscard]] orthoball::ShapeEdits edits(const EditOptions& options);

/// "filled 2 holes of volume 3; left out 1 region of volume 0.5; 2 regions left".
template <int D>
[[nodiscard]] std::string text_of(const orthoball::EditedShape<D>& shape,
                                  const EditOptions& options);

/// The keys `region`, `regions` (how many are left), `regions_dropped`, `volume_dropped`,
/// `holes_filled`, `volume_filled`.
template <int D>
void add_json(nlohmann::ordered_json& json, const orthoball::EditedShape<D>& shape,
              const EditOptions& options);

extern template std::string text_of(const orthoball::EditedShape<2>&, const EditOptions&);
extern template std::string text_of(const orthoball::EditedShape<3>&,
                                    const EditOptions&);  // in edit_options.cpp
extern template void add_json(nlohmann::ordered_json&, const orthoball::EditedShape<2>&,
                              const EditOptions&);
extern template void add_json(nlohmann::ordered_json&, const orthoball::EditedShape<3>&,
                              const EditOptions&);
