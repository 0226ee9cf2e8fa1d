// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/balls.h"
#include "orthoball/measures/molecular_surface.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/queries/voids.h"
#include "orthoball/topology/betti.h"

// The report of `measure`, as text and as JSON.

/// What happened to the rows: each is counted once.
struct BallCounts {
  std::size_t exposed = 0;     ///< have a part of the surface
  std::size_t buried = 0;      ///< have none: other balls cover it
  std::size_t hidden = 0;      ///< have no power cell
  std::size_t duplicates = 0;  ///< of an earlier row
  std::size_t empty = 0;       ///< have no radius above 0
};

template <int D>
[[nodiscard]] BallCounts ball_counts(const Loaded& input,
                                     const orthoball::Filtration<D>& filtration,
                                     const orthoball::UnionOfBalls& balls);

/// What both forms of the report say.
template <int D>
struct Measured {
  ChosenBalls chosen;
  orthoball::UnionOfBalls balls;
  orthoball::BettiNumbers<D> betti;
  orthoball::VoidsOf voids_of;
  std::vector<orthoball::Void<D>> voids;
  BallCounts counts;
  std::optional<orthoball::MolecularSurface> molecular_surface;  ///< in space, of a probe above 0
};

/// @param missing  counts numbers beyond the double range, which are null.
template <int D>
[[nodiscard]] std::string json_report(const Loaded& input, const Measured<D>& measured,
                                      std::size_t& missing);

template <int D>
[[nodiscard]] std::string text_report(const Loaded& input, const Measured<D>& measured);

extern template BallCounts ball_counts(const Loaded&, const orthoball::Filtration<2>&,
                                       const orthoball::UnionOfBalls&);  // in measure_report.cpp
extern template std::string json_report(const Loaded&, const Measured<2>&, std::size_t&);
extern template std::string text_report(const Loaded&, const Measured<2>&);
extern template BallCounts ball_counts(const Loaded&, const orthoball::Filtration<3>&,
                                       const orthoball::UnionOfBalls&);
extern template std::string json_report(const Loaded&, const Measured<3>&, std::size_t&);
extern template std::string text_report(const Loaded&, const Measured<3>&);
