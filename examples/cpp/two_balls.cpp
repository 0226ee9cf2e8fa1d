// SPDX-License-Identifier: MIT
// Two balls of radius 1 whose centres are 3 apart: at which alpha2 does their shape change?
#include <orthoball/orthoball.h>

#include <iostream>

int main() {
  using namespace orthoball;
  const WeightedPoints balls(3, {0, 0, 0, 3, 0, 0}, WeightKind::radius, {1, 1});
  const Filtration<3> filtration(regular_triangulation<3>(balls));
  const Filter<3> filter(filtration);

  std::cout << "Orthoball " << kVersion << '\n';
  for (std::uint32_t index = 1; index <= filtration.spectrum_size(); ++index) {
    std::cout << "at alpha2 " << filtration.alpha2(index) << " there are "
              << filter.complex_size(index) << " simplices\n";
  }
  // The centres enter at -1; the edge at (3/2)^2 - 1, where the grown balls touch.
  const bool is_right = filtration.spectrum_size() == 2 && filtration.alpha2(2) == 1.25;
  return is_right ? 0 : 1;
}
