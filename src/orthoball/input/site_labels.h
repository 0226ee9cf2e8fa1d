// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace orthoball {

/// Who a row is, for reports and the viewer. Arrays are empty where the format does not say.
struct SiteLabels {
  std::vector<std::uint32_t> line;      ///< [row] 1-based line of the file, text formats
  std::vector<std::string> element;     ///< [row] "C", "Ca", "H"; molecules
  std::vector<std::string> atom;        ///< [row] atom name, blanks removed
  std::vector<std::string> residue;     ///< [row] residue name
  std::vector<std::string> residue_id;  ///< [row] residue number with insertion code
  std::vector<std::string> chain;       ///< [row]
};

/// The label of a row among those of one kind; empty where the format does not say.
[[nodiscard]] inline std::string_view label_of(const std::vector<std::string>& labels,
                                               std::size_t row) {
  return row < labels.size() ? std::string_view(labels[row]) : std::string_view();
}

}  // namespace orthoball
