// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace orthoball {

/// Sorts labels ascending, -0 before 0, and takes the rows along: `rows[i]` stays with `labels[i]`.
/// Equal labels end in any order, which is the same for the same input. Not for NaN.
///
/// In place; O(n) time for each of at most eight digits, fewer where labels differ early.
void sort_labels(std::span<double> labels, std::span<std::uint32_t> rows);

}  // namespace orthoball
