// SPDX-License-Identifier: MIT
// What a molecule takes: volume and area of its atoms, by itself and for a water molecule as probe.
#include <orthoball/orthoball.h>

#include <iostream>

int main() {
  using namespace orthoball;
  const Reading reading = read("c60.xyz", {});  // radii by element
  bool is_hollow = true;
  for (const double probe : {0.0, 1.4}) {
    const WeightedPoints atoms = with_probe(reading.points, {.nearest = probe});
    const Filtration<3> filtration(regular_triangulation<3>(atoms));
    const std::uint32_t index = filtration.index(0.0);
    const UnionOfBalls balls = union_of_balls(filtration, index, 0.0, {});
    std::cout << "probe " << probe << ": volume " << balls.volume << ", area " << balls.area
              << '\n';
    for (const Void<3>& hole : voids(filtration, index, 0.0, VoidsOf::balls)) {
      std::cout << "  a void of volume " << hole.volume << " with room for a ball of radius "
                << hole.largest_ball_radius << '\n';
    }
    // The cage has a void, and room for the centre of a probe.
    is_hollow = is_hollow && filtration.triangulation().vertex_count() == 60 && balls.euler == 2;
  }
  return is_hollow ? 0 : 1;
}
