// SPDX-License-Identifier: MIT
#include "generators/cases.h"

#include <cstdlib>
#include <string_view>

#include "generators/random.h"

namespace orthoball::generators {

std::ostream& operator<<(std::ostream& stream, const Case& one) {
  return stream << name(one.family) << ", dimension " << one.dimension << ", " << one.count
                << " sites, seed " << one.seed;
}

bool is_long_run() {
  const char* const value = std::getenv("ORTHOBALL_LONG");
  return value != nullptr && std::string_view(value) == "1";
}

std::vector<Case> cases(std::size_t seeds, std::size_t smallest, std::size_t largest) {
  if (is_long_run()) seeds *= 10;
  std::vector<Case> cases;
  for (const PointFamily family : point_families()) {
    for (int dimension = 2; dimension <= 3; ++dimension) {
      for (std::size_t seed = 0; seed < seeds; ++seed) {
        const std::size_t spread = Random(seed).bits() % (largest - smallest + 1);
        const std::size_t count = seed == 0 ? largest : smallest + spread;
        cases.push_back({family, dimension, count, seed});
      }
    }
  }
  return cases;
}

}  // namespace orthoball::generators
