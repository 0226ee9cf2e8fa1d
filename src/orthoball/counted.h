// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace orthoball {

/// "column" for 1, else "columns"; knows vertices and tetrahedra.
[[nodiscard]] inline std::string noun_of(std::size_t count, std::string_view noun) {
  std::string word(noun);
  if (count == 1) return word;
  const auto ends_with = [&](std::string_view end) {
    return noun.size() >= end.size() && noun.substr(noun.size() - end.size()) == end;
  };
  if (ends_with("vertex")) return word.replace(word.size() - 2, 2, "ices");
  if (ends_with("hedron")) return word.replace(word.size() - 2, 2, "a");
  return word + 's';
}

/// "1 column", "2 columns".
[[nodiscard]] inline std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + ' ' + noun_of(count, noun);
}

}  // namespace orthoball
