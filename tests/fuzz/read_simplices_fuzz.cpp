// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>

#include "orthoball/error.h"
#include "orthoball/input/simplex_rows.h"

// The bytes of a list of simplices of 100 points in space: it is refused, or every simplex has 2 to
// 4 ascending rows of these and a line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint32_t kSites = 100;
  const orthoball::Source source{"input", std::string(reinterpret_cast<const char*>(data), size)};
  try {
    const orthoball::SimplexList list = orthoball::read_simplices(source, 3, kSites);
    if (list.rows.empty() || list.rows.size() != list.line.size()) __builtin_trap();
    for (const auto& rows : list.rows) {
      if (rows.size() < 2 || rows.size() > 4 || rows.back().row() >= kSites) __builtin_trap();
      for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i - 1] >= rows[i]) __builtin_trap();
      }
    }
  } catch (const orthoball::ParseError& error) {
    if (std::string(error.what()).empty()) __builtin_trap();
  }
  return 0;
}
