// SPDX-License-Identifier: MIT
//
// Around each vertex the edges of the complex are the segments of its disk's part. Between one and
// the next counterclockwise lies either a triangle of the complex, whose orthocentre both segments
// end in, or an arc of the circle on the boundary of the union.
#include "orthoball/queries/planar_union.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "orthoball/measures/scaled_balls.h"

namespace orthoball {
namespace {

using Point = std::array<double, 2>;

// An edge as seen from one of its ends.
struct Spoke {
  std::uint32_t to = 0;  // the other end
  SimplexId edge;
  SimplexId after;           // the triangle that follows counterclockwise; none on the hull
  std::uint32_t next = 0;    // and the other end of the spoke behind it
  bool follows_none = true;  // no triangle lies before it
};

// An edge of the complex from its lower to its higher vertex.
struct Segment {
  Lens<2> lens;
  std::array<Point, 2> ends;  // to the right, to the left
};

// Whether a third disk's centre lies to the left of the axis of two.
bool is_left(const Lens<2>& lens, const Sphere<2>& first, const Sphere<2>& third) {
  return lens.axis[0] * (third.x[1] - first.x[1]) - lens.axis[1] * (third.x[0] - first.x[0]) > 0.0;
}
// The point of equal power to both disks at a distance from the axis, to the left or right.
Point across(const Lens<2>& lens, const Sphere<2>& first, bool left, double distance) {
  const double offset = left ? distance : -distance;
  return {first.x[0] + lens.height[0] * lens.axis[0] - offset * lens.axis[1],
          first.x[1] + lens.height[0] * lens.axis[1] + offset * lens.axis[0]};
}

class Parts {
 public:
  Parts(const Filtration<2>& filtration, std::uint32_t index, double alpha2)
      : filtration_(filtration), index_(index), balls_(filtration, index, alpha2) {}

  PlanarUnion found() {
    part_of_.resize(filtration_.count(0));
    arcs_.resize(filtration_.count(0));
    find_spokes();
    find_centres();
    segments_.resize(filtration_.count(1));
    for (std::uint32_t i = 0; i < filtration_.count(1); ++i) {
      if (is_in(SimplexId(filtration_.table().first(1) + i))) segments_[i] = segment(i);
    }
    for (std::uint32_t vertex = 0; vertex < filtration_.count(0); ++vertex) {
      if (is_in(SimplexId(vertex))) add_part(vertex);
    }
    find_outline();
    const InputUnits lengths = balls_.units(1);
    const auto in = [&](Point& point) {
      for (double& x : point) x = lengths({x, 0.0});
    };
    for (DiskPart& part : result_.parts) {
      in(part.centre);
      part.radius = lengths({part.radius, 0.0});
      for (DiskPiece& piece : part.boundary) {
        in(piece.from);
        in(piece.to);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_in(SimplexId simplex) const {
    return simplex.exists() && filtration_.enters(simplex) <= index_;
  }
  [[nodiscard]] const Sphere<2>& disk(std::uint32_t vertex) const {
    return balls_.spheres()[vertex];
  }
  void find_spokes();
  void find_centres();
  [[nodiscard]] Segment segment(std::uint32_t i) const;
  void add_part(std::uint32_t vertex);
  void find_outline();
  // The end of a spoke's segment, to its right (0) or left (1).
  [[nodiscard]] Point end_of(std::uint32_t vertex, const Spoke& spoke, std::size_t side) const {
    const Segment& segment = segments_[spoke.edge.row() - filtration_.table().first(1)];
    return segment.ends[vertex < spoke.to ? side : 1 - side];
  }
  // Half the angle of the circle that the other disk covers.
  [[nodiscard]] double opening(std::uint32_t vertex, const Spoke& spoke) const {
    const Segment& segment = segments_[spoke.edge.row() - filtration_.table().first(1)];
    return angle(segment.lens.opening(vertex < spoke.to ? 0 : 1));
  }

  const Filtration<2>& filtration_;
  std::uint32_t index_;
  ScaledBalls<2> balls_;
  std::vector<std::vector<Spoke>> spokes_;  // [vertex]: counterclockwise
  std::vector<Point> centres_;              // [triangle]: orthocentres of those of the complex
  std::vector<Segment> segments_;           // [edge]
  // [vertex]: the pieces that are arcs, with the spoke's end that each begins at and ends at.
  struct Arc {
    std::uint32_t piece, from, to;
  };
  std::vector<std::vector<Arc>> arcs_;
  std::vector<std::uint32_t> part_of_;  // [vertex]
  PlanarUnion result_;
};

void Parts::find_spokes() {
  const SimplexTable<2>& table = filtration_.table();
  spokes_.resize(filtration_.count(0));
  for (std::uint32_t i = 0; i < filtration_.count(1); ++i) {
    const SimplexId edge(table.first(1) + i);
    const auto ends = filtration_.vertices(edge);
    spokes_[ends[0].row()].push_back({ends[1].row(), edge, {}, 0, true});
    spokes_[ends[1].row()].push_back({ends[0].row(), edge, {}, 0, true});
  }
  for (auto& spokes : spokes_) {
    std::sort(spokes.begin(), spokes.end(),
              [](const Spoke& a, const Spoke& b) { return a.to < b.to; });
  }
  const auto spoke = [](std::vector<Spoke>& spokes, std::uint32_t to) -> Spoke& {
    return *std::lower_bound(spokes.begin(), spokes.end(), to,
                             [](const Spoke& one, std::uint32_t end) { return one.to < end; });
  };
  const auto cells = filtration_.triangulation().cells<2>();
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const auto& corners = cells[cell].corners;
    for (std::size_t i = 0; i < 3; ++i) {
      Spoke& before = spoke(spokes_[corners[i]], corners[(i + 1) % 3]);
      before.after = SimplexId(table.first(2) + cell);
      before.next = corners[(i + 2) % 3];
      spoke(spokes_[corners[i]], before.next).follows_none = false;
    }
  }
  if (cells.empty()) return;  // two at most, one to each side
  for (auto& spokes : spokes_) {
    std::vector<Spoke> ring;
    const auto on_hull = std::find_if(spokes.begin(), spokes.end(),
                                      [](const Spoke& one) { return one.follows_none; });
    ring.push_back(on_hull == spokes.end() ? spokes.front() : *on_hull);
    while (ring.size() < spokes.size()) ring.push_back(spoke(spokes, ring.back().next));
    spokes = std::move(ring);
  }
}

// Told by the edge with the smallest circle.
void Parts::find_centres() {
  const std::uint32_t first = filtration_.table().first(2);
  centres_.resize(filtration_.count(2));
  for (std::uint32_t i = 0; i < centres_.size(); ++i) {
    if (!is_in(SimplexId(first + i))) continue;
    const auto vertices = filtration_.vertices(SimplexId(first + i));
    std::array<const Sphere<2>*, 3> disks{};
    std::array<double, 3> circle2{};
    for (std::size_t k = 0; k < 3; ++k) disks[k] = &disk(vertices[k].row());
    for (std::size_t k = 0; k < 3; ++k) circle2[k] = rough_circle2(*disks[k], *disks[(k + 1) % 3]);
    const auto least = std::min_element(circle2.begin(), circle2.end()) - circle2.begin();
    std::rotate(disks.begin(), disks.begin() + least, disks.end());
    const Lens<2> lens = orthoball::lens(*disks[0], *disks[1]);
    centres_[i] = across(lens, *disks[0], is_left(lens, *disks[0], *disks[2]),
                         offset_across(lens, *disks[0], *disks[2]));
  }
}

Segment Parts::segment(std::uint32_t i) const {
  const SimplexId edge(filtration_.table().first(1) + i);
  const auto vertices = filtration_.vertices(edge);
  const Sphere<2>&first = disk(vertices[0].row()), &second = disk(vertices[1].row());
  Segment segment{lens(first, second), {}};
  const Lens<2>& lens = segment.lens;
  for (const bool left : {false, true}) {
    segment.ends[left ? 1 : 0] = across(lens, first, left, lens.radius);
  }
  if (filtration_.triangulation().affine_dimension() < 2) return segment;
  for (const SimplexId triangle : filtration_.cells_beside(edge)) {
    if (!is_in(triangle)) continue;
    for (const VertexId vertex : filtration_.vertices(triangle)) {
      if (vertex == vertices[0] || vertex == vertices[1]) continue;
      segment.ends[is_left(lens, first, disk(vertex.row())) ? 1 : 0] =
          centres_[triangle.row() - filtration_.table().first(2)];
    }
  }
  return segment;
}

void Parts::add_part(std::uint32_t vertex) {
  const Sphere<2>& own = disk(vertex);
  DiskPart part{filtration_.triangulation().sites().row(vertex), own.x, own.radius, {}};
  std::vector<Spoke> in;  // those of the complex; `after` only where the triangle is, too
  for (Spoke spoke : spokes_[vertex]) {
    if (!is_in(spoke.edge)) continue;
    if (!is_in(spoke.after)) spoke.after = {};
    in.push_back(spoke);
  }
  part_of_[vertex] = static_cast<std::uint32_t>(result_.parts.size());
  constexpr double kAll = 2 * std::numbers::pi;
  if (in.empty()) {
    const Point start{own.x[0] + own.radius, own.x[1]};
    part.boundary.push_back({start, start, kAll, {}});
    arcs_[vertex].push_back({0, vertex, vertex});
  }
  const auto direction = [&](const Spoke& spoke) {
    const Sphere<2>& other = disk(spoke.to);
    return Point{other.x[0] - own.x[0], other.x[1] - own.x[1]};
  };
  for (std::size_t i = 0; i < in.size(); ++i) {
    const Spoke &spoke = in[i], &next = in[(i + 1) % in.size()];
    part.boundary.push_back({end_of(vertex, spoke, 0), end_of(vertex, spoke, 1), 0.0,
                             filtration_.triangulation().sites().row(spoke.to)});
    if (spoke.after.exists()) continue;
    double between = kAll;
    if (in.size() > 1) {
      const Point a = direction(spoke), b = direction(next);
      between = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
      if (between < 0.0) between += kAll;
    }
    const double turn = between - opening(vertex, spoke) - opening(vertex, next);
    arcs_[vertex].push_back({static_cast<std::uint32_t>(part.boundary.size()), spoke.to, next.to});
    part.boundary.push_back(
        {end_of(vertex, spoke, 1), end_of(vertex, next, 0), std::clamp(turn, 0.0, kAll), {}});
  }
  result_.parts.push_back(std::move(part));
}

// Where an arc ends at the edge to k, the boundary goes on with the arc of disk k that begins
// there.
void Parts::find_outline() {
  std::vector<std::vector<bool>> is_done(arcs_.size());
  for (std::size_t vertex = 0; vertex < arcs_.size(); ++vertex) {
    std::sort(arcs_[vertex].begin(), arcs_[vertex].end(),
              [](const Arc& a, const Arc& b) { return a.from < b.from; });
    is_done[vertex].resize(arcs_[vertex].size());
  }
  for (std::uint32_t first = 0; first < arcs_.size(); ++first) {
    for (std::size_t start = 0; start < arcs_[first].size(); ++start) {
      if (is_done[first][start]) continue;
      std::vector<OutlineArc> curve;
      std::uint32_t vertex = first;
      std::size_t at = start;
      while (!is_done[vertex][at]) {
        is_done[vertex][at] = true;
        const Arc& arc = arcs_[vertex][at];
        curve.push_back({part_of_[vertex], arc.piece});
        const std::uint32_t before = vertex;
        vertex = arc.to;
        const auto& arcs = arcs_[vertex];
        at = static_cast<std::size_t>(
            std::lower_bound(arcs.begin(), arcs.end(), before,
                             [](const Arc& one, std::uint32_t from) { return one.from < from; }) -
            arcs.begin());
      }
      result_.outline.push_back(std::move(curve));
    }
  }
}

}  // namespace

PlanarUnion planar_union(const Filtration<2>& filtration, std::uint32_t index, double alpha2) {
  return Parts(filtration, index, alpha2).found();
}

}  // namespace orthoball
