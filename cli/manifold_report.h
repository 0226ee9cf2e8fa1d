// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/queries/manifold_solid.h"

// What shape --manifold says of the solid it wrote.

/// [dimension]: the singular simplices of a shape, which are no part of the solid.
template <int D>
using DroppedSimplices = std::array<std::size_t, std::size_t{D}>;

template <int D>
[[nodiscard]] DroppedSimplices<D> dropped_simplices(const orthoball::AlphaComplex<D>& shape);

/// The key `manifold` of the report.
/// @param missing  grows by the numbers that are beyond the range of doubles.
template <int D>
[[nodiscard]] nlohmann::ordered_json manifold_json(const orthoball::ManifoldSolid<D>& solid,
                                                   const DroppedSimplices<D>& dropped,
                                                   std::size_t& missing);

/// Two lines for people: the solid; what was changed and left out.
template <int D>
[[nodiscard]] std::array<std::string, 2> manifold_text(const orthoball::ManifoldSolid<D>& solid,
                                                       const DroppedSimplices<D>& dropped);

extern template DroppedSimplices<2> dropped_simplices(const orthoball::AlphaComplex<2>&);
extern template DroppedSimplices<3> dropped_simplices(const orthoball::AlphaComplex<3>&);
extern template nlohmann::ordered_json manifold_json<2>(const orthoball::ManifoldSolid<2>&,
                                                        const DroppedSimplices<2>&, std::size_t&);
extern template nlohmann::ordered_json manifold_json<3>(const orthoball::ManifoldSolid<3>&,
                                                        const DroppedSimplices<3>&, std::size_t&);
extern template std::array<std::string, 2> manifold_text<2>(const orthoball::ManifoldSolid<2>&,
                                                            const DroppedSimplices<2>&);
extern template std::array<std::string, 2> manifold_text<3>(const orthoball::ManifoldSolid<3>&,
                                                            const DroppedSimplices<3>&);
