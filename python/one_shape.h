// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

#include "orthoball/alpha_shapes.h"
#include "orthoball/queries/edited_shape.h"
#include "python/module.h"

/// One shape of a family, which outlives it.
struct OneShape {
  const orthoball::AlphaShapes* shapes;
  double alpha2;  ///< that was asked for; length^2
  std::variant<orthoball::EditedShape<2>, orthoball::EditedShape<3>> edited;

  [[nodiscard]] const orthoball::WeightedPoints& points() const { return shapes->points(); }
};

/// Calls `visit` with the AlphaComplex<D> of a shape while other Python threads run. It must not
/// touch Python.
template <class Visit>
auto without_gil(const OneShape& shape, const Visit& visit) {
  const nanobind::gil_scoped_release released;
  return std::visit([&](const auto& edited) { return visit(edited.complex); }, shape.edited);
}
