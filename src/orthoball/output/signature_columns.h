// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/output/npz.h"

namespace orthoball {

/// The arrays that signatures of shapes and of unions of balls begin with: index, alpha2, alpha,
/// betti and euler. Exact but for alpha.
/// @param rows  each has a `signature` with these, and `alpha`.
template <int D, class Row>
void add_first_columns(NpzWriter& archive, const std::vector<Row>& rows) {
  archive.add_column<std::uint32_t>("index", rows,
                                    [](const auto& row) { return row.signature.index; });
  archive.add_column<double>("alpha2", rows, [](const auto& row) { return row.signature.alpha2; });
  archive.add_column<double>("alpha", rows, [](const auto& row) { return row.alpha; });
  archive.add_columns("betti", D, rows,
                      [](const auto& row) { return std::span(row.signature.betti); });
  archive.add_column<std::int64_t>("euler", rows,
                                   [](const auto& row) { return row.signature.euler; });
}

}  // namespace orthoball
