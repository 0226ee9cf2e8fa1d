// SPDX-License-Identifier: MIT
#include "benchmarks/inputs.h"

#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"

namespace orthoball::benchmarks {
namespace {

using generators::Random;

constexpr std::uint64_t kSeed = 1;

WeightedPoints fixed_point(int dimension, std::size_t count, Random& random) {
  std::vector<double> coordinates(count * static_cast<std::size_t>(dimension));
  for (double& x : coordinates) x = random.integer(0, 100000);
  return WeightedPoints::fixed_point(dimension, 5, std::move(coordinates), WeightKind::none, {});
}

WeightedPoints noisy_sphere(int dimension, std::size_t count, Random& random) {
  std::vector<double> coordinates;
  while (coordinates.size() < count * static_cast<std::size_t>(dimension)) {
    std::array<double, 3> x{random.normal(), random.normal(),
                            dimension == 3 ? random.normal() : 0.0};
    const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    if (length < 0.1) continue;
    const double radius = 1.0 + 1e-3 * random.normal();
    for (int axis = 0; axis < dimension; ++axis) {
      coordinates.push_back(x[static_cast<std::size_t>(axis)] * radius / length);
    }
  }
  return {dimension, std::move(coordinates), WeightKind::none, {}};
}

WeightedPoints atoms(int dimension, std::size_t count, Random& random) {
  constexpr std::array kRadii{1200.0, 1520.0, 1550.0, 1700.0, 1800.0};
  const double spacing = std::cbrt(10.0), jitter = (spacing - 1.2) / 2;
  const auto side = static_cast<std::size_t>(
      std::ceil(std::pow(static_cast<double>(count), 1.0 / dimension) - 1e-9));
  std::vector<double> coordinates, radii;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    for (int axis = 0; axis < dimension; ++axis, rest /= side) {
      const double x = static_cast<double>(rest % side) * spacing + random.uniform(-jitter, jitter);
      coordinates.push_back(std::round(1000 * x));
    }
    radii.push_back(kRadii[static_cast<std::size_t>(random.integer(0, kRadii.size() - 1))]);
  }
  return WeightedPoints::fixed_point(dimension, 3, std::move(coordinates), WeightKind::radius,
                                     std::move(radii));
}

WeightedPoints hidden(int dimension, std::size_t count, Random& random) {
  const double largest = 1.5 * std::pow(static_cast<double>(count), -1.0 / dimension);
  std::vector<double> coordinates, radii;
  for (std::size_t i = 0; i < count; ++i) {
    for (int axis = 0; axis < dimension; ++axis) coordinates.push_back(random.uniform());
    radii.push_back(random.uniform(0, largest));
  }
  return {dimension, std::move(coordinates), WeightKind::radius, std::move(radii)};
}

WeightedPoints ordered_input(const std::string& family, int dimension, std::size_t count) {
  Random random(kSeed);
  if (family == "fixed_point") return fixed_point(dimension, count, random);
  if (family == "noisy_sphere") return noisy_sphere(dimension, count, random);
  if (family == "atoms") return atoms(dimension, count, random);
  if (family == "hidden") return hidden(dimension, count, random);
  for (const generators::PointFamily one : generators::point_families()) {
    if (name(one) == family) return generators::points_of(one, dimension, count, kSeed);
  }
  throw std::invalid_argument("no family " + family);
}

}  // namespace

WeightedPoints input(const std::string& family, int dimension, std::size_t count) {
  return generators::with_rows(ordered_input(family, dimension, count),
                               generators::random_permutation(count, kSeed));
}

std::uint64_t fingerprint(const WeightedPoints& points) {
  std::uint64_t print = 0;
  const auto add = [&](std::span<const double> numbers) {
    for (const double number : numbers) {
      print = (print ^ std::bit_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15U;
      print ^= print >> 29U;
    }
  };
  add(points.coordinates());
  add(points.weights());
  return print;
}

}  // namespace orthoball::benchmarks
