// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
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

}  // namespace orthoball
