// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "orthoball/output/byte_sink.h"
#include "orthoball/signatures/ball_signature.h"

namespace orthoball {

/// One row of a table of unions of balls with both forms of the parameter, as the caller asked.
template <int D>
struct BallSignatureRow {
  BallSignature<D> signature;
  double alpha = 0.0;  ///< signed root of signature.alpha2
};

// Unions of balls, column by column `index, alpha2, alpha, betti_0.., euler, volume, area`. In the
// plane volume is the area of the union and area its perimeter. Index 0 itself, where all balls are
// empty, has no alpha2 and alpha: nothing stands there, in the archive -infinity.

/// A CSV table.
template <int D>
void write_ball_signatures_csv(ByteSink& sink, const std::vector<BallSignatureRow<D>>& rows);
/// An array of JSON objects, betti an array by dimension.
template <int D>
void write_ball_signatures_json(ByteSink& sink, const std::vector<BallSignatureRow<D>>& rows);
/// The columns as arrays for NumPy: `betti` uint32 (n, D), `index` uint32, `euler` int64, all
/// others float64 (n).
template <int D>
void write_ball_signatures_npz(ByteSink& sink, const std::vector<BallSignatureRow<D>>& rows);

}  // namespace orthoball
