// SPDX-License-Identifier: MIT
#include "orthoball/queries/sphere_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

#include "orthoball/vectors.h"

namespace orthoball {
namespace {

using Vector = std::array<double, 3>;

Vector unit(Vector vector) {
  const double length = std::sqrt(inner(vector, vector));
  for (double& x : vector) x /= length;
  return vector;
}

using Triangle = std::array<std::uint32_t, 3>;

SphereTriangles icosahedron() {
  SphereTriangles result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double one : {-1.0, 1.0}) {
      for (const double golden : {-std::numbers::phi, std::numbers::phi}) {
        Vector corner{};
        corner[(axis + 1) % 3] = one;
        corner[(axis + 2) % 3] = golden;
        result.corners.push_back(unit(corner));
      }
    }
  }
  const auto& x = result.corners;
  // Neighbours see each other from the centre under an angle of cosine 1 / sqrt(5), others under
  // right angles or more.
  const auto are_near = [&](std::uint32_t a, std::uint32_t b) { return inner(x[a], x[b]) > 0.25; };
  for (std::uint32_t a = 0; a < 12; ++a) {
    for (std::uint32_t b = a + 1; b < 12; ++b) {
      for (std::uint32_t c = a + 1; c < 12; ++c) {
        if (c == b || !are_near(a, b) || !are_near(b, c) || !are_near(c, a)) continue;
        if (inner(cross_product(x[a], x[b]), x[c]) > 0.0) result.all.push_back({a, b, c});
      }
    }
  }
  return result;
}

// Each triangle in four, by the middles of its sides.
SphereTriangles divided(const SphereTriangles& triangles) {
  SphereTriangles result{triangles.corners, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto number = static_cast<std::uint32_t>(result.corners.size());
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), number);
    if (is_new) {
      Vector sum;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        sum[axis] = triangles.corners[a][axis] + triangles.corners[b][axis];
      }
      result.corners.push_back(unit(sum));
    }
    return place->second;
  };
  for (const auto& [a, b, c] : triangles.all) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Triangle& part : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      result.all.push_back(part);
    }
  }
  return result;
}

// How far the middles of the triangles are from the sphere at most.
double depth(const SphereTriangles& triangles) {
  double nearest = 1.0;
  for (const auto& [a, b, c] : triangles.all) {
    const auto& x = triangles.corners;
    const auto normal = unit(cross_product(difference(x[b], x[a]), difference(x[c], x[a])));
    nearest = std::min(nearest, inner(normal, x[a]));
  }
  return 1.0 - nearest;
}

}  // namespace

SphereTriangles sphere_triangles(double tolerance) {
  SphereTriangles triangles = icosahedron();
  while (depth(triangles) > tolerance) triangles = divided(triangles);
  return triangles;
}

}  // namespace orthoball
