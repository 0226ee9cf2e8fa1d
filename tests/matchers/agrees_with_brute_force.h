// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "oracles/brute_force.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball::matchers {

/// What a triangulation gets wrong, as sentences; empty if it is what the definitions say.
template <int D>
[[nodiscard]] std::vector<std::string> differences(const RegularTriangulation<D>& triangulation,
                                                   const oracles::BruteForce& expected);

/// The same for a filtration: every simplex with its three indices and its place in the filter,
/// the exact spectrum with its labels, faces and cells, and what the queries of Filtration give.
template <int D>
[[nodiscard]] std::vector<std::string> differences(const Filtration<D>& filtration,
                                                   const oracles::BruteForce& expected);

extern template std::vector<std::string> differences(const RegularTriangulation<2>&,
                                                     const oracles::BruteForce&);
extern template std::vector<std::string> differences(const RegularTriangulation<3>&,
                                                     const oracles::BruteForce&);
extern template std::vector<std::string> differences(const Filtration<2>&,
                                                     const oracles::BruteForce&);
extern template std::vector<std::string> differences(const Filtration<3>&,
                                                     const oracles::BruteForce&);

}  // namespace orthoball::matchers
