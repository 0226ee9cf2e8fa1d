// SPDX-License-Identifier: MIT
#include "generators/point_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "generators/random.h"

namespace orthoball::generators {

namespace {

constexpr std::array kFamilies{
    PointFamily::uniform,      PointFamily::uniform_balls, PointFamily::gaussian,
    PointFamily::protein_like, PointFamily::scan_like,     PointFamily::grid,
    PointFamily::lattice,      PointFamily::cospherical,   PointFamily::coplanar,
    PointFamily::collinear,    PointFamily::duplicated,    PointFamily::nested_balls,
    PointFamily::same_centres, PointFamily::hidden_heavy,  PointFamily::near_sphere,
    PointFamily::one_ulp,      PointFamily::huge,          PointFamily::tiny,
    PointFamily::mixed_scales};

using Point = std::array<double, 3>;

// Sites in the making: the third coordinate is left out in the plane.
struct Draft {
  int dimension = 3;
  WeightKind kind = WeightKind::none;
  int decimals = -1;  // fixed point unless negative
  std::vector<Point> positions = {};
  std::vector<double> weights = {};

  void add(const Point& position, double weight = 0.0) {
    positions.push_back(position);
    weights.push_back(weight);
  }
  [[nodiscard]] WeightedPoints points() const {
    std::vector<double> coordinates;
    for (const Point& position : positions) {
      for (int axis = 0; axis < dimension; ++axis) {
        coordinates.push_back(position[static_cast<std::size_t>(axis)]);
      }
    }
    std::vector<double> kept;
    if (kind != WeightKind::none) kept = weights;
    if (decimals >= 0) {
      return WeightedPoints::fixed_point(dimension, decimals, std::move(coordinates), kind,
                                         std::move(kept));
    }
    return {dimension, std::move(coordinates), kind, std::move(kept)};
  }
};

WeightKind any_kind(Random& random) {
  constexpr std::array kinds{WeightKind::none, WeightKind::weight, WeightKind::radius};
  return kinds[static_cast<std::size_t>(random.integer(0, 2))];
}

Point any_integers(Random& random, int low, int high) {
  Point point{};
  for (double& x : point) x = random.integer(low, high);
  return point;
}

double squared_length(const Point& point, int dimension) {
  const double flat = point[0] * point[0] + point[1] * point[1];
  return dimension == 2 ? flat : flat + point[2] * point[2];
}

// Side of a box in which `count` points have about unit distance from their neighbours.
double side_of(std::size_t count, int dimension) {
  return std::max(1.0, std::round(std::pow(static_cast<double>(count), 1.0 / dimension)));
}

void add_uniform(Draft& draft, std::size_t count, Random& random, bool has_radii) {
  if (has_radii) draft.kind = WeightKind::radius;
  const double spacing = 1.0 / side_of(count, draft.dimension);
  for (std::size_t i = 0; i < count; ++i) {
    const Point position{random.uniform(), random.uniform(), random.uniform()};
    draft.add(position, spacing * random.uniform(0.5, 1.1));
  }
}

void add_gaussian(Draft& draft, std::size_t count, Random& random) {
  draft.kind = WeightKind::weight;
  for (std::size_t i = 0; i < count; ++i) {
    const Point position{random.normal(), random.normal(), random.normal()};
    draft.add(position, 0.1 * random.normal());
  }
}

// Steps of a bond's length that turn back when they leave the ball that the chain should fill.
void add_protein_like(Draft& draft, std::size_t count, Random& random) {
  constexpr std::array radii{1.70, 1.70, 1.70, 1.55, 1.52, 1.80, 1.20};
  draft.kind = WeightKind::radius;
  draft.decimals = 3;
  const double extent = 1.6 * side_of(count, draft.dimension);
  Point position{};
  while (draft.positions.size() < count) {
    Point step{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (draft.dimension == 2) step[2] = 0.0;
    const double length = std::sqrt(squared_length(step, 3));
    if (length > 1.0 || length < 0.1) continue;
    Point next = position;
    for (std::size_t axis = 0; axis < 3; ++axis) next[axis] += step[axis] * 1.5 / length;
    if (squared_length(next, 3) > extent * extent) {
      for (double& x : position) x *= 0.9;
      continue;
    }
    position = next;
    Point rounded{};
    for (std::size_t axis = 0; axis < 3; ++axis) rounded[axis] = std::round(1000 * position[axis]);
    const auto element = static_cast<std::size_t>(random.integer(0, radii.size() - 1));
    draft.add(rounded, std::round(1000 * radii[element]));
  }
}

void add_scan_like(Draft& draft, std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    Point position{random.uniform(-1, 1), random.uniform(-1, 1), 0.0};
    const double x = position[0], y = position[1];
    position[2] = x * x - 0.5 * y * y + x * y + 1e-4 * random.normal();
    if (draft.dimension == 2) position[1] = x * x * x + 1e-4 * random.normal();
    draft.add(position);
  }
}

void add_grid(Draft& draft, std::size_t count) {
  const auto side = static_cast<std::size_t>(
      std::ceil(std::pow(static_cast<double>(count), 1.0 / draft.dimension) - 1e-9));
  for (std::size_t i = 0; i < count; ++i) {
    draft.add({static_cast<double>(i % side), static_cast<double>(i / side % side),
               static_cast<double>(i / side / side)});
    if (draft.dimension == 2) draft.positions.back()[1] = static_cast<double>(i / side);
  }
}

void add_lattice(Draft& draft, std::size_t count, Random& random) {
  draft.kind = any_kind(random);
  const int side = static_cast<int>(side_of(count, draft.dimension)) + random.integer(0, 2);
  const int heaviest = random.integer(0, 4);
  for (std::size_t i = 0; i < count; ++i) {
    draft.add(any_integers(random, 0, side), random.integer(-heaviest, heaviest));
  }
}

// All signs and orders of the integer solutions of x^2 + y^2 (+ z^2) = square.
std::vector<Point> integer_sphere(int square, int dimension) {
  std::vector<Point> sphere;
  const int side = static_cast<int>(std::ceil(std::sqrt(square)));
  for (int x = -side; x <= side; ++x) {
    for (int y = -side; y <= side; ++y) {
      for (int z = dimension == 2 ? 0 : -side; z <= (dimension == 2 ? 0 : side); ++z) {
        if (x * x + y * y + z * z != square) continue;
        sphere.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  return sphere;
}

void add_cospherical(Draft& draft, std::size_t count, Random& random) {
  constexpr std::array flat_squares{5, 25, 65, 325};
  constexpr std::array squares{3, 9, 14, 41, 81};
  draft.kind = any_kind(random);
  const int spheres = random.integer(1, 2);
  const auto each = count / static_cast<std::size_t>(spheres) + 1;
  while (draft.positions.size() < count) {
    const int square = draft.dimension == 2
                           ? flat_squares[static_cast<std::size_t>(random.integer(0, 3))]
                           : squares[static_cast<std::size_t>(random.integer(0, 4))];
    const std::vector<Point> sphere = integer_sphere(square, draft.dimension);
    const double weight = random.integer(-3, 3);
    for (std::size_t i = 0; i < each && draft.positions.size() < count; ++i) {
      draft.add(sphere[random.bits() % sphere.size()], weight);
    }
  }
  if (random.coin() && count > 0) draft.positions.back() = {};  // the centre
}

void add_coplanar(Draft& draft, std::size_t count, Random& random) {
  draft.kind = any_kind(random);
  const Point u = any_integers(random, -2, 2), v = any_integers(random, -2, 2);
  const Point origin = any_integers(random, -9, 9);
  const int side = static_cast<int>(side_of(count, 2)) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = random.integer(0, side), b = random.integer(0, side);
    Point position{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      position[axis] = origin[axis] + a * u[axis] + (draft.dimension == 3 ? b * v[axis] : 0.0);
    }
    if (draft.dimension == 2 && random.coin()) position[0] += 1.0;
    draft.add(position, random.integer(-2, 2));
  }
}

void add_collinear(Draft& draft, std::size_t count, Random& random) {
  draft.kind = any_kind(random);
  const Point origin = any_integers(random, -9, 9), step = any_integers(random, -3, 3);
  const int side = static_cast<int>(count) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = random.integer(0, side);
    draft.add({origin[0] + a * step[0], origin[1] + a * step[1], origin[2] + a * step[2]},
              random.integer(-3, 3));
  }
}

void add_duplicated(Draft& draft, std::size_t count, Random& random) {
  draft.kind = any_kind(random);
  const int distinct = std::max(1, static_cast<int>(count) / random.integer(2, 4));
  Draft pool;
  for (int i = 0; i < distinct; ++i) {
    pool.add(random.coin() ? any_integers(random, -1, 2)
                           : Point{random.uniform(), random.uniform(), -0.0},
             random.integer(-1, 2));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto chosen = static_cast<std::size_t>(random.integer(0, distinct - 1));
    draft.add(pool.positions[chosen], pool.weights[chosen]);
  }
}

// Each ball is moved from the one before by as much as its radius is smaller, or a little less.
void add_nested_balls(Draft& draft, std::size_t count, Random& random) {
  draft.kind = WeightKind::radius;
  Point position{};
  double radius = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (radius <= 0.0) {
      position = any_integers(random, -8, 8);
      radius = random.integer(4, 10);
    }
    draft.add(position, radius);
    const int step = random.integer(1, 2);
    const auto axis = static_cast<std::size_t>(random.integer(0, draft.dimension - 1));
    position[axis] += random.coin() ? step : -step;
    radius -= random.coin() ? step : step + 1;
  }
}

void add_same_centres(Draft& draft, std::size_t count, Random& random) {
  draft.kind = random.coin() ? WeightKind::radius : WeightKind::weight;
  const int centres = std::max(1, static_cast<int>(count) / random.integer(1, 4));
  std::vector<Point> pool;
  for (int i = 0; i < centres; ++i) pool.push_back(any_integers(random, 0, 3));
  for (std::size_t i = 0; i < count; ++i) {
    draft.add(pool[static_cast<std::size_t>(random.integer(0, centres - 1))],
              random.integer(-4, 4));
  }
}

void add_hidden_heavy(Draft& draft, std::size_t count, Random& random) {
  draft.kind = WeightKind::radius;
  const bool is_integral = random.coin();
  for (std::size_t i = 0; i < count; ++i) {
    Point position = any_integers(random, 0, 6);
    if (!is_integral) position = {random.uniform(), random.uniform(), random.uniform()};
    const double scale = is_integral ? 6.0 : 1.0;
    const double radius = i % 6 == 0 ? scale * 0.5 : scale * 0.5 * random.integer(-1, 1);
    draft.add(position, radius);
  }
}

void add_near_sphere(Draft& draft, std::size_t count, Random& random) {
  while (draft.positions.size() < count) {
    Point position{random.normal(), random.normal(), random.normal()};
    if (draft.dimension == 2) position[2] = 0.0;
    const double length = std::sqrt(squared_length(position, 3));
    if (length < 0.1) continue;
    for (double& x : position) x /= length;
    draft.add(position);
  }
}

void add_one_ulp(Draft& draft, std::size_t count, Random& random) {
  constexpr double ulp = std::numeric_limits<double>::epsilon();
  draft.kind = any_kind(random);
  const double base = random.coin() ? 1.0 : 0.0;  // at 0 the corners of the unit box as well
  for (std::size_t i = 0; i < count; ++i) {
    Point position{};
    for (double& x : position) {
      x = (base == 0.0 && random.coin() ? 0.0 : 1.0) + ulp * random.integer(0, 2);
    }
    draft.add(position, 1.0 + ulp * random.integer(0, 2));
  }
}

// Magnitudes 2^lowest to 2^highest, one for all sites or one for each number.
void add_scaled(Draft& draft, std::size_t count, Random& random, int lowest, int highest) {
  draft.kind = any_kind(random);
  const bool is_common = random.coin();
  const int common = random.integer(lowest, highest);
  const auto number = [&](double mantissa) {
    return std::ldexp(mantissa, is_common ? common : random.integer(lowest, highest));
  };
  const bool is_integral = random.coin();
  const auto mantissa = [&] {
    return is_integral ? random.integer(-4, 4) / 4.0 : random.uniform(-1, 1);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Point position{number(mantissa()), number(mantissa()), number(mantissa())};
    draft.add(position, number(0.5 * mantissa()));
  }
}

}  // namespace

std::span<const PointFamily> point_families() { return kFamilies; }

const char* name(PointFamily family) {
  switch (family) {
    case PointFamily::uniform:
      return "uniform";
    case PointFamily::uniform_balls:
      return "uniform_balls";
    case PointFamily::gaussian:
      return "gaussian";
    case PointFamily::protein_like:
      return "protein_like";
    case PointFamily::scan_like:
      return "scan_like";
    case PointFamily::grid:
      return "grid";
    case PointFamily::lattice:
      return "lattice";
    case PointFamily::cospherical:
      return "cospherical";
    case PointFamily::coplanar:
      return "coplanar";
    case PointFamily::collinear:
      return "collinear";
    case PointFamily::duplicated:
      return "duplicated";
    case PointFamily::nested_balls:
      return "nested_balls";
    case PointFamily::same_centres:
      return "same_centres";
    case PointFamily::hidden_heavy:
      return "hidden_heavy";
    case PointFamily::near_sphere:
      return "near_sphere";
    case PointFamily::one_ulp:
      return "one_ulp";
    case PointFamily::huge:
      return "huge";
    case PointFamily::tiny:
      return "tiny";
    case PointFamily::mixed_scales:
      return "mixed_scales";
  }
  throw std::logic_error("a family without a name");
}

bool is_extreme(PointFamily family) {
  return family == PointFamily::huge || family == PointFamily::tiny ||
         family == PointFamily::mixed_scales;
}

WeightedPoints points_of(PointFamily family, int dimension, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Draft draft{.dimension = dimension};
  switch (family) {
    case PointFamily::uniform:
      add_uniform(draft, count, random, false);
      break;
    case PointFamily::uniform_balls:
      add_uniform(draft, count, random, true);
      break;
    case PointFamily::gaussian:
      add_gaussian(draft, count, random);
      break;
    case PointFamily::protein_like:
      add_protein_like(draft, count, random);
      break;
    case PointFamily::scan_like:
      add_scan_like(draft, count, random);
      break;
    case PointFamily::grid:
      add_grid(draft, count);
      break;
    case PointFamily::lattice:
      add_lattice(draft, count, random);
      break;
    case PointFamily::cospherical:
      add_cospherical(draft, count, random);
      break;
    case PointFamily::coplanar:
      add_coplanar(draft, count, random);
      break;
    case PointFamily::collinear:
      add_collinear(draft, count, random);
      break;
    case PointFamily::duplicated:
      add_duplicated(draft, count, random);
      break;
    case PointFamily::nested_balls:
      add_nested_balls(draft, count, random);
      break;
    case PointFamily::same_centres:
      add_same_centres(draft, count, random);
      break;
    case PointFamily::hidden_heavy:
      add_hidden_heavy(draft, count, random);
      break;
    case PointFamily::near_sphere:
      add_near_sphere(draft, count, random);
      break;
    case PointFamily::one_ulp:
      add_one_ulp(draft, count, random);
      break;
    case PointFamily::huge:
      add_scaled(draft, count, random, 900, 1023);
      break;
    case PointFamily::tiny:
      add_scaled(draft, count, random, -1072, -900);
      break;
    case PointFamily::mixed_scales:
      add_scaled(draft, count, random, -500, 500);
      break;
  }
  return draft.points();
}

WeightedPoints with_rows(const WeightedPoints& points, std::span<const std::uint32_t> rows) {
  const auto dimension = static_cast<std::size_t>(points.dimension());
  std::vector<double> coordinates, weights, weights_low;
  for (const std::uint32_t row : rows) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      coordinates.push_back(points.coordinates()[dimension * row + axis]);
    }
    if (!points.weights().empty()) weights.push_back(points.weights()[row]);
    if (!points.weights_low().empty()) weights_low.push_back(points.weights_low()[row]);
  }
  if (!points.decimals()) {
    return {points.dimension(), std::move(coordinates), points.weight_kind(), std::move(weights)};
  }
  return WeightedPoints::fixed_point(points.dimension(), *points.decimals(), std::move(coordinates),
                                     points.weight_kind(), std::move(weights),
                                     std::move(weights_low));
}

WeightedPoints scaled_by_power_of_two(const WeightedPoints& points, int exponent) {
  if (points.decimals()) throw std::invalid_argument("decimals have no powers of two");
  const auto scaled = [](std::span<const double> numbers, int by) {
    std::vector<double> result;
    for (const double number : numbers) {
      result.push_back(std::ldexp(number, by));
      if (std::ldexp(result.back(), -by) != number) throw std::invalid_argument("inexact scaling");
    }
    return result;
  };
  const int of_weights = points.weight_kind() == WeightKind::radius ? exponent : 2 * exponent;
  return {points.dimension(), scaled(points.coordinates(), exponent), points.weight_kind(),
          scaled(points.weights(), of_weights)};
}

std::vector<std::uint32_t> random_permutation(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint32_t> permutation(count);
  std::iota(permutation.begin(), permutation.end(), 0U);
  for (std::size_t i = count; i > 1; --i)
    std::swap(permutation[i - 1], permutation[random.bits() % i]);
  return permutation;
}

}  // namespace orthoball::generators
