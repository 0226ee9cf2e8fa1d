// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "matchers/describe.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball::matchers {

template <class T>
[[nodiscard]] bool same_bytes(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

/// Where a triangulation of shuffled rows names other sites than that of the rows in their order.
/// Vertices must be the same by number; of equal rows any may stand for the others.
/// @param order  row i of the shuffled points is row `order[i]` of the original ones.
template <int D>
[[nodiscard]] std::vector<std::string> renaming_faults(const RegularTriangulation<D>& original,
                                                       const RegularTriangulation<D>& shuffled,
                                                       std::span<const std::uint32_t> order) {
  std::vector<std::string> found;
  Comparison compare(found);
  // Every original row by the lowest row that equals it.
  std::map<std::uint32_t, std::uint32_t> representative;
  for (const Duplicate& duplicate : original.duplicates()) {
    representative[duplicate.row.row()] = duplicate.representative.row();
  }
  const auto renamed = [&](SiteId row) {
    const std::uint32_t old = order[row.row()];
    const auto place = representative.find(old);
    return place == representative.end() ? old : place->second;
  };

  compare("number of vertices", shuffled.vertex_count(), original.vertex_count());
  compare("number of duplicates", shuffled.duplicates().size(), original.duplicates().size());
  if (!found.empty()) return found;
  for (std::size_t vertex = 0; vertex < original.vertex_count(); ++vertex) {
    compare("row of vertex " + std::to_string(vertex), renamed(shuffled.sites().row(vertex)),
            original.sites().row(vertex).row());
  }
  std::vector<std::uint32_t> hidden, expected_hidden;
  for (const SiteId row : shuffled.hidden()) hidden.push_back(renamed(row));
  for (const SiteId row : original.hidden()) expected_hidden.push_back(row.row());
  std::sort(hidden.begin(), hidden.end());
  compare("hidden rows", hidden, expected_hidden);
  return found;
}

}  // namespace orthoball::matchers
