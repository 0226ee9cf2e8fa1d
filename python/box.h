// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "orthoball/queries/power_cells.h"
#include "python/module.h"

/// Lower corner, then upper.
using MaybeBox = std::optional<std::vector<double>>;

/// The box that was typed; by default that around the balls.
template <int D>
[[nodiscard]] orthoball::Box<D> box_of(const orthoball::Filtration<D>& filtration,
                                       const MaybeBox& typed) {
  if (!typed) return orthoball::box_around(filtration, 0.0);
  if (typed->size() != 2 * std::size_t{D}) {
    refuse("a box has two corners of the sites' dimension");
  }
  orthoball::Box<D> box;
  std::copy_n(typed->begin(), D, box.lower.begin());
  std::copy_n(typed->begin() + D, D, box.upper.begin());
  return box;
}
