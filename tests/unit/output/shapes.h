// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {

/// Points with their filtration, for tests of what is written of them.
template <int D>
struct Shapes {
  explicit Shapes(std::vector<double> coordinates)
      : points(D, std::move(coordinates), WeightKind::none, {}),
        filtration(regular_triangulation<D>(points)) {}

  WeightedPoints points;
  Filtration<D> filtration;
};

/// What `write` gives to a sink.
template <class Write>
std::string written(const Write& write) {
  std::ostringstream out;
  ByteSink sink(out, "null");
  write(sink);
  sink.flush();
  return out.str();
}

/// An octahedron, a triangle that only its edges hold, two points joined by an edge, and a point,
/// far from each other: at index(0.6) a shape with every kind of boundary simplex.
inline Shapes<3> mixed_shapes() {
  return Shapes<3>({1,  0,  0,  -1, 0,  0,  0,    1,    0,  0,  -1, 0, 0,  0, 1, 0, 0,  -1,
                    50, 50, 50, 51, 50, 50, 50.4, 50.9, 50, 90, 0,  0, 91, 0, 0, 0, 95, 0});
}

/// A square of `n` x `n` cells of size 1 without those for which `is_hole(column, row)`: its points
/// are the corners of the cells kept, with the middle of each.
template <class IsHole>
Shapes<2> checkered(int n, const IsHole& is_hole) {
  std::vector<double> coordinates;
  std::vector<std::pair<int, int>> corners;
  const auto corner = [&](int x, int y) {
    for (const auto& known : corners) {
      if (known == std::pair(x, y)) return;
    }
    corners.emplace_back(x, y);
    coordinates.push_back(x);
    coordinates.push_back(y);
  };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (is_hole(x, y)) continue;
      for (const int dx : {0, 1}) {
        for (const int dy : {0, 1}) corner(x + dx, y + dy);
      }
      coordinates.push_back(x + 0.5);
      coordinates.push_back(y + 0.5);
    }
  }
  return Shapes<2>(std::move(coordinates));
}

}  // namespace orthoball
