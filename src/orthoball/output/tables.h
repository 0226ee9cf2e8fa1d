// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filter.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/signatures/signature.h"

namespace orthoball {

// The filter: one row per simplex in the order of by_rows(), positions from 1. `vertices` are
// ascending input rows from 0, `alpha2` the label of the index `enters`; `enters`, `regular`,
// `interior` indices of the spectrum from 1, with no value where that never happens. Only the first
// `count` simplices are written; a table of K_i has complex_size(i).

/// `position,dimension,vertices,alpha2,enters,regular,interior`, vertices with blanks between.
template <int D>
void write_filter_csv(ByteSink& sink, const Filter<D>& filter, std::size_t count);

/// One JSON object a line with the keys of the CSV; `vertices` an array, null for never.
template <int D>
void write_filter_json_lines(ByteSink& sink, const Filter<D>& filter, std::size_t count);

/// Arrays for NumPy, n = count: `dimension` uint8 (n), `vertices` uint32 (n, D + 1) filled up with
/// 4294967295, `alpha2` float64 (n), `enters`, `regular`, `interior` uint32 (n) with 0 for never,
/// `spectrum` float64 (s).
template <int D>
void write_filter_npz(ByteSink& sink, const Filter<D>& filter, std::size_t count);

/// One row of a table of signatures with both forms of the parameter, as the caller asked for it.
template <int D>
struct SignatureRow {
  Signature<D> signature;
  double alpha = 0.0;  ///< signed root of signature.alpha2
};

// Signatures, column by column `index, alpha2, alpha, betti_0.., euler, exterior_0..exterior_D,
// singular_.., regular_.., interior_.., volume, area_singular, area_regular, area, length`. In the
// plane there is no length. Index 0 itself, the empty complex, has no alpha2 and alpha: nothing
// stands there, in the archive -infinity.

/// The head of the CSV table.
template <int D>
void write_signature_head_csv(ByteSink& sink);
template <int D>
void write_signature_csv(ByteSink& sink, const SignatureRow<D>& row);

/// One JSON object; betti and the counts by role are arrays by dimension; length null in the plane.
template <int D>
void write_signature_json(ByteSink& sink, const SignatureRow<D>& row);

/// The columns as arrays for NumPy: `betti` uint32 (n, D), counts by role uint32 (n, D + 1),
/// `index` uint32, `euler` int64, everything else float64 (n).
template <int D>
void write_signatures_npz(ByteSink& sink, const std::vector<SignatureRow<D>>& rows);

}  // namespace orthoball
