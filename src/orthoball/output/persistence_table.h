// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/topology/persistence.h"

namespace orthoball {

/// What births and deaths are told by.
enum class PersistenceValues {
  alpha2,  ///< length^2
  index,   ///< of the spectrum
};

// Persistence pairs, one row each, in their order: `dimension`, `birth` and `death`, and the
// simplices that bring them about as ascending input rows, `birth_simplex` and `death_simplex`.

/// `dimension,birth,death,birth_simplex,death_simplex`, rows with blanks between; death and
/// death_simplex empty for never.
template <int D>
void write_persistence_csv(ByteSink& sink, const Filtration<D>& filtration,
                           const PersistencePairs<D>& pairs, PersistenceValues values);

/// An array of objects with these keys; the simplices arrays, null for never.
template <int D>
void write_persistence_json(ByteSink& sink, const Filtration<D>& filtration,
                            const PersistencePairs<D>& pairs, PersistenceValues values);

/// The text that GUDHI's programs write and read: lines `2 dimension birth death`, 2 standing for
/// coefficients in Z/2, `inf` for never.
template <int D>
void write_persistence_gudhi(ByteSink& sink, const Filtration<D>& filtration,
                             const PersistencePairs<D>& pairs, PersistenceValues values);

}  // namespace orthoball
