// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/output/byte_sink.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// Writes points as CSV with the columns x, y[, z] and, where there are any, weight or radius.
///
/// Exact: decimal fixed point is written digit by digit, doubles as the shortest text that reads
/// back to the same double. So read() gives the same points, with --radius-column radius or
/// --weight-column weight.
void write_points_csv(ByteSink& sink, const WeightedPoints& points);

/// The points that are read from such a table: where their shortest texts are decimals that fixed
/// point can hold, these instead of the doubles nearest to them.
[[nodiscard]] WeightedPoints as_written(const WeightedPoints& points);

}  // namespace orthoball
