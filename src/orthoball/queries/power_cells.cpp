// SPDX-License-Identifier: MIT
//
// A power cell is what its neighbours leave of the box: a half-space for each, cut off one after
// the other, the nearest first so that most is gone early. Lengths are seen from the site, so that
// a small cell is as exact as a large one. Orthocentres are not used: those of nearly flat cells at
// the hull are far away and known to few digits, while the planes are known to all.
//
// Aurenhammer. Power diagrams: properties, algorithms and applications. SIAM Journal on Computing
// 16 (1987).
#include "orthoball/queries/power_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/queries/convex_polytope.h"
#include "orthoball/queries/power_neighbours.h"

namespace orthoball {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Labels of facets that are no vertices: the sphere, and from the second on the sides of the box.
constexpr std::uint32_t kOnSphere = 0xFFFFFFF0U, kOnBox = kOnSphere + 1;

// Where the power to one ball is at most that to another with another centre, seen from the first.
template <int D>
HalfSpace<D> nearer_half(const Sphere<D>& one, const Sphere<D>& other) {
  HalfSpace<D> half;
  double largest = 0.0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    half.normal[axis] = other.x[axis] - one.x[axis];
    largest = std::max(largest, std::abs(half.normal[axis]));
  }
  // By a power of two: what is exact stays so, and no square vanishes.
  const int exponent = largest > 0.0 ? -std::ilogb(largest) : 0;
  half.offset = std::ldexp(one.weight - other.weight, exponent) / 2;
  for (double& x : half.normal) {
    const double difference = x;
    x = std::ldexp(x, exponent);
    half.offset += x * difference / 2;
  }
  return half;
}

template <int D>
bool has_normal(const HalfSpace<D>& half) {
  return std::any_of(half.normal.begin(), half.normal.end(), [](double x) { return x != 0.0; });
}

template <int D>
double height(const HalfSpace<D>& half) {
  double square = 0.0;
  for (const double x : half.normal) square += x * x;
  return half.offset / std::sqrt(square);
}

// The vertices in the order of their rows.
template <int D>
std::vector<VertexId> vertices_by_row(const Sites<D>& sites) {
  std::vector<VertexId> vertices;
  for (std::uint32_t vertex = 0; vertex < sites.size(); ++vertex) vertices.emplace_back(vertex);
  std::sort(vertices.begin(), vertices.end(),
            [&](VertexId a, VertexId b) { return sites.row(a.row()) < sites.row(b.row()); });
  return vertices;
}

template <int D>
class PowerCells {
 public:
  PowerCells(const Filtration<D>& filtration, ScaledBalls<D> balls, const PowerCellOptions& options)
      : sites_(filtration.triangulation().sites()),
        balls_(std::move(balls)),
        neighbours_(filtration, options.threads),
        options_(options),
        lengths_(balls_.units(1)),
        areas_(balls_.units(D - 1)),
        volumes_(balls_.units(D)) {}

  struct Cut {
    double height;
    std::uint32_t neighbour;
    HalfSpace<D> half;
  };
  // What one thread keeps from cell to cell.
  struct Room {
    ConvexPolytope<D> polytope;
    std::vector<Cut> cuts;
  };

  // result[i] = cell(vertices[i], room)
  template <class Cell>
  [[nodiscard]] std::vector<PowerCell<D>> cells(std::span<const VertexId> vertices,
                                                const Cell& cell) const {
    constexpr std::size_t kAtOnce = 64;
    std::vector<PowerCell<D>> result(vertices.size());
    parallel_parts(options_.threads, vertices.size(), vertices.size() / kAtOnce + 1,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     Room room;
                     for (std::size_t i = begin; i < end; ++i) {
                       result[i] = cell(vertices[i], room);
                     }
                   });
    return result;
  }

  // The cell in a box, in the units of the balls.
  [[nodiscard]] PowerCell<D> in_box(VertexId vertex, const Box<D>& box, Room& room) const {
    PowerCell<D> cell;
    cell.row = sites_.row(vertex.row());
    if (!neighbours_.has_inside(vertex)) return cell;
    Box<D> seen = box;
    const Sphere<D>& ball = balls_.spheres()[vertex.row()];
    for (std::size_t axis = 0; axis < D; ++axis) {
      seen.lower[axis] -= ball.x[axis];
      seen.upper[axis] -= ball.x[axis];
    }
    room.polytope = ConvexPolytope<D>(seen.lower, seen.upper, kOnBox);
    cut(vertex, kInfinity, room);
    measure(room.polytope, cell);
    if (options_.surfaces) take_surface(room.polytope, ball, cell);
    return cell;
  }

  // The surface of a cell in its ball.
  // @param sphere  a polytope in the unit sphere.
  void add_surface(VertexId vertex, const ConvexPolytope<D>& sphere, PowerCell<D>& cell,
                   Room& room) const {
    const Sphere<D>& ball = balls_.spheres()[vertex.row()];
    if (!neighbours_.has_inside(vertex) || !(ball.radius > 0.0)) return;
    room.polytope = sphere;
    room.polytope.scale(ball.radius);
    cut(vertex, ball.radius, room);
    room.polytope.join_corners();
    take_surface(room.polytope, ball, cell);
  }

 private:
  // By the neighbours whose planes are nearer than `reach`, the nearest first.
  void cut(VertexId vertex, double reach, Room& room) const {
    const auto spheres = balls_.spheres();
    const Sphere<D>& ball = spheres[vertex.row()];
    room.cuts.clear();
    for (const VertexId neighbour : neighbours_.of(vertex)) {
      const HalfSpace<D> half = nearer_half(ball, spheres[neighbour.row()]);
      const double its_height = height(half);
      // Without a normal they are closer than doubles can tell.
      if (has_normal(half) && its_height < reach) {
        room.cuts.push_back({its_height, neighbour.row(), half});
      }
    }
    std::sort(room.cuts.begin(), room.cuts.end(), [](const Cut& a, const Cut& b) {
      return std::pair(a.height, a.neighbour) < std::pair(b.height, b.neighbour);
    });
    for (const Cut& one : room.cuts) {
      room.polytope.cut(one.half, one.neighbour);
      if (room.polytope.is_empty()) return;
    }
  }

  void measure(ConvexPolytope<D>& polytope, PowerCell<D>& cell) const {
    cell.is_clipped = polytope.is_empty();
    cell.volume = polytope.is_empty() ? 0.0 : volumes_({std::max(0.0, polytope.volume()), 0.0});
    polytope.join_corners();
    double area = 0.0, exposed = 0.0;
    std::uint32_t last = kOnSphere;
    for (const auto& facet : polytope.facets()) {
      const double its_area = polytope.area(facet);
      area += its_area;
      if (facet.label > kOnSphere) {
        exposed += its_area;
        cell.is_clipped = true;
      } else if (facet.label != std::exchange(last, facet.label)) {
        ++cell.facet_count;
      }
    }
    cell.area = areas_({area, 0.0});
    cell.exposed_area = areas_({exposed, 0.0});
  }

  void take_surface(const ConvexPolytope<D>& polytope, const Sphere<D>& ball,
                    PowerCell<D>& cell) const {
    for (auto corner : polytope.corners()) {
      for (std::size_t axis = 0; axis < D; ++axis) {
        corner[axis] = lengths_({corner[axis] + ball.x[axis], 0.0});
      }
      cell.corners.push_back(corner);
    }
    for (const auto& [label, begin, end] : polytope.facets()) {
      PowerFacet& facet = cell.facets.emplace_back(PowerFacet{{}, 0, begin, end});
      if (label < kOnSphere) facet.neighbour = sites_.row(label);
      if (label > kOnSphere) facet.side = static_cast<std::uint8_t>(label - kOnBox);
    }
    cell.loops.assign(polytope.loops().begin(), polytope.loops().end());
  }

  const Sites<D>& sites_;
  ScaledBalls<D> balls_;
  PowerNeighbours<D> neighbours_;
  PowerCellOptions options_;
  InputUnits lengths_, areas_, volumes_;
};

// The box in the units of the balls.
template <int D>
Box<D> scaled(const Box<D>& box, const ScaledBalls<D>& balls) {
  constexpr double kLargest = 0x1p+300;  // beyond, volumes overflow
  const auto refuse = [](InputError::Reason reason, const char* message) {
    throw InputError(reason, InputError::kNoRow, message);
  };
  Box<D> result;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double lower = box.lower[axis], upper = box.upper[axis];
    if (!std::isfinite(lower) || !std::isfinite(upper)) {
      refuse(InputError::Reason::not_finite, "the box of power cells must be finite");
    }
    if (!(lower < upper)) {
      refuse(InputError::Reason::wrong_argument,
             "the box of power cells must have its upper sides above the lower ones");
    }
    result.lower[axis] = balls.from_input(lower, 1);
    result.upper[axis] = balls.from_input(upper, 1);
    if (!(std::max(-result.lower[axis], result.upper[axis]) < kLargest)) {
      refuse(InputError::Reason::wrong_argument,
             "the box of power cells is more than 2^150 times as large as all sites");
    }
  }
  return result;
}

// What a ball's part has in common with others.
struct Touching {
  double area = 0.0;
  std::uint32_t count = 0;
};

// [row]. The smallest areas are added first, so that sums do not depend on the order of rows.
std::vector<Touching> touching_of(const UnionOfBalls& balls) {
  std::vector<Contact> contacts = balls.contacts;
  std::sort(contacts.begin(), contacts.end(),
            [](const Contact& a, const Contact& b) { return a.area < b.area; });
  std::vector<Touching> result(balls.areas.size());
  for (const Contact& contact : contacts) {
    for (const SiteId row : contact.rows) {
      result[row.row()].area += contact.area;
      if (contact.area > 0.0) ++result[row.row()].count;
    }
  }
  return result;
}

}  // namespace

template <int D>
Box<D> box_around(const Filtration<D>& filtration, double alpha2) {
  if (!std::isfinite(alpha2)) {
    throw InputError(InputError::Reason::not_finite, InputError::kNoRow,
                     "alpha2 of a box around balls must be finite");
  }
  const ScaledBalls<D> balls(filtration, 0, alpha2);
  Box<D> box;
  if (balls.spheres().empty()) return box;
  box.lower.fill(kInfinity);
  box.upper.fill(-kInfinity);
  for (const Sphere<D>& ball : balls.spheres()) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], ball.x[axis] - ball.radius);
      box.upper[axis] = std::max(box.upper[axis], ball.x[axis] + ball.radius);
    }
  }
  const InputUnits lengths = balls.units(1);
  double longest = 0.0, furthest = 0.0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box.lower[axis] = lengths({box.lower[axis], 0.0});
    box.upper[axis] = lengths({box.upper[axis], 0.0});
    longest = std::max(longest, box.upper[axis] - box.lower[axis]);
    furthest = std::max({furthest, -box.lower[axis], box.upper[axis]});
  }
  // Far from the origin, so much at least that doubles can tell the sides apart.
  constexpr double kTold = 0x1p-40;
  const double margin = std::max({longest > 0.0 ? longest / 10 : 0.5, kTold * furthest,
                                  std::numeric_limits<double>::denorm_min()});
  for (std::size_t axis = 0; axis < D; ++axis) {
    box.lower[axis] -= margin;
    box.upper[axis] += margin;
  }
  return box;
}

template <int D>
std::vector<PowerCell<D>> power_cells(const Filtration<D>& filtration, const Box<D>& box,
                                      const PowerCellOptions& options) {
  if (filtration.count(0) == 0) return {};
  ScaledBalls<D> balls(filtration, 0, -kInfinity);  // their radii are not used
  const Box<D> seen = scaled(box, balls);
  const PowerCells<D> cells(filtration, std::move(balls), options);
  const auto vertices = vertices_by_row(filtration.triangulation().sites());
  return cells.cells(vertices,
                     [&](VertexId vertex, auto& room) { return cells.in_box(vertex, seen, room); });
}

template <int D>
std::vector<PowerCell<D>> power_cells_in_balls(const Filtration<D>& filtration,
                                               const UnionOfBalls& balls,
                                               const PowerCellOptions& options) {
  if (!(options.tolerance >= PowerCellOptions::kLeastTolerance &&
        options.tolerance <= PowerCellOptions::kLargestTolerance)) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "the tolerance of power cells is not from 0.0001 to 0.5");
  }
  const auto& sites = filtration.triangulation().sites();
  const std::vector<Touching> touching = touching_of(balls);
  std::vector<VertexId> vertices;
  for (const VertexId vertex : vertices_by_row(sites)) {
    if (filtration.enters(SimplexId(vertex.row())) <= balls.index) vertices.push_back(vertex);
  }
  const PowerCells<D> cells(filtration, ScaledBalls<D>(filtration, balls.index, balls.alpha2),
                            options);
  const auto sphere = ConvexPolytope<D>::in_unit_sphere(options.tolerance, kOnSphere);
  return cells.cells(vertices, [&](VertexId vertex, auto& room) {
    PowerCell<D> cell;
    cell.row = sites.row(vertex.row());
    const std::size_t row = cell.row.row();
    cell.volume = balls.volumes[row];
    cell.exposed_area = balls.areas[row];
    cell.area = balls.areas[row] + touching[row].area;
    cell.facet_count = touching[row].count;
    cell.is_clipped = filtration.interior(SimplexId(vertex.row())) > balls.index;
    if (options.surfaces) cells.add_surface(vertex, sphere, cell, room);
    return cell;
  });
}

template Box<2> box_around(const Filtration<2>&, double);
template Box<3> box_around(const Filtration<3>&, double);
template std::vector<PowerCell<2>> power_cells(const Filtration<2>&, const Box<2>&,
                                               const PowerCellOptions&);
template std::vector<PowerCell<3>> power_cells(const Filtration<3>&, const Box<3>&,
                                               const PowerCellOptions&);
template std::vector<PowerCell<2>> power_cells_in_balls(const Filtration<2>&, const UnionOfBalls&,
                                                        const PowerCellOptions&);
template std::vector<PowerCell<3>> power_cells_in_balls(const Filtration<3>&, const UnionOfBalls&,
                                                        const PowerCellOptions&);

}  // namespace orthoball
