// SPDX-License-Identifier: MIT
// Two balls of radius 1 whose centres are 3 apart: at which alpha2 does the edge between them
// enter?
#include <orthoball/orthoball.h>

#include <iostream>

int main() {
  const orthoball::WeightedPoints balls(3, {0, 0, 0, 3, 0, 0}, orthoball::WeightKind::radius,
                                        {1, 1});
  std::cout << "Orthoball " << orthoball::kVersion << ": " << balls.size() << " balls\n";
}
