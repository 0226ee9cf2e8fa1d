// SPDX-License-Identifier: MIT
//
// The union of balls falls into pieces: the cells of the dual complex; on every side of a triangle
// that no cell covers, the tetrahedron to the point where its three spheres meet; around every
// edge, between these, wedges of a double cone; and around every vertex what is left of the ball.
// Around an edge, cells and tetrahedra leave arcs of the circle, and, seen along the edge, the
// facet is the polygon of the orthocentres of the cells, with a corner of the disk where an arc
// begins or ends.
//
// docs/derivations/union_of_balls.md has the formulas.
#include "orthoball/measures/contact_facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "orthoball/filtration/edge_ring.h"
#include "orthoball/filtration/face_vertices.h"

namespace orthoball {
namespace {

// The corners of each edge and the two others, which follow counterclockwise about the edge.
constexpr std::array<std::array<std::uint8_t, 4>, 6> kTurn{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

unsigned corner_of(const CellRecord<3>& record, std::uint32_t vertex) {
  const auto& corners = record.corners;
  return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : corners[2] == vertex ? 2 : 3;
}

// One tetrahedron in the ring of an edge, which turns from its corner behind to that ahead.
struct Turn {
  std::uint32_t cell;
  unsigned behind, ahead;
};

// Calls visit(turn) for the tetrahedra from `turn` on until visit is false, the hull is met or the
// ring is closed. Whether it was closed.
template <class Visit>
bool turn_on(std::span<const CellRecord<3>> cells, Turn turn, const Visit& visit) {
  const std::uint32_t start = turn.cell;
  while (true) {
    visit(turn);
    const std::uint32_t beyond = cells[turn.cell].neighbours[turn.behind];
    if (beyond == kOutside) return false;
    const std::uint32_t kept = cells[turn.cell].corners[turn.ahead];
    if (beyond / 4 == start) return true;
    turn = {beyond / 4, corner_of(cells[beyond / 4], kept), beyond % 4};
  }
}

// Whether of two edges at one centre the circle of the first is to tell a solid angle between them:
// the smaller one does it best.
bool tells_better(const Lens<3>& lens, const Sphere<3>& centre, std::uint32_t to,
                  const Sphere<3>& third, std::uint32_t to_third, bool centre_is_first) {
  const Lens<3> other =
      centre_is_first ? orthoball::lens(centre, third) : orthoball::lens(third, centre);
  return lens.radius2 < other.radius2 || (lens.radius2 == other.radius2 && to < to_third);
}

// The third vertices of the triangles around an edge, counterclockwise about it; those of the hull
// first and last where it is on the hull.
void look_around(const Filtration<3>& filtration, std::uint32_t index, SimplexId edge,
                 std::array<std::uint32_t, 2> ends, std::vector<ApexOfEdge>& room) {
  room.clear();
  const SimplexTable<3>& table = filtration.table();
  const auto cells = filtration.triangulation().cells<3>();
  const auto is_in = [&](SimplexId simplex) { return filtration.enters(simplex) <= index; };
  if (cells.empty()) {
    if (filtration.triangulation().affine_dimension() != 2) return;
    for (const SimplexId triangle : filtration.cells_beside(edge)) {
      for (const VertexId vertex : filtration.vertices(triangle)) {
        if (vertex.row() != ends[0] && vertex.row() != ends[1]) {
          room.push_back({vertex.row(), is_in(triangle), false});
        }
      }
    }
    return;
  }
  const std::uint32_t owner = table.edge_owners()[edge.row() - table.first(1)];
  const auto& turn = kTurn[owner % 6];
  Turn start{owner / 6, turn[2], turn[3]};
  if (cells[start.cell].corners[turn[0]] != ends[0]) std::swap(start.behind, start.ahead);

  const bool is_interior = filtration.interior(edge) <= index;
  const auto cell_is_in = [&](std::uint32_t cell) {
    return is_interior || is_in(SimplexId(table.first(3) + cell));
  };
  const auto triangle_is_in = [&](std::uint32_t cell, unsigned left_out) {
    return is_in(SimplexId(table.first(2) + table.facet_of_cell(cells, cell, left_out)));
  };
  Turn last = start;
  const auto push = [&](const Turn& at) {
    const bool before = !room.empty() && room.back().cell_is_in;
    const bool after = cell_is_in(at.cell);
    room.push_back({cells[at.cell].corners[at.behind],
                    before || after || triangle_is_in(at.cell, at.ahead), after});
    last = at;
  };
  if (turn_on(cells, start, push)) return;
  // Back from the start to the hull, which is to turn the other way, and then all of it from there.
  room.clear();
  turn_on(cells, Turn{start.cell, start.ahead, start.behind}, [&](const Turn& at) { last = at; });
  start = {last.cell, last.ahead, last.behind};
  turn_on(cells, start, push);
  room.push_back({cells[last.cell].corners[last.ahead],
                  room.back().cell_is_in || triangle_is_in(last.cell, last.behind), false});
}

}  // namespace

template <int D>
ContactFacets<D>::ContactFacets(const Filtration<D>& filtration, std::uint32_t index, double alpha2)
    : filtration_(&filtration), index_(index) {
  const Sites<D>& sites = filtration.triangulation().sites();
  spheres_.resize(sites.size());
  for (std::size_t vertex = 0; vertex < sites.size(); ++vertex) {
    const Site<D>& site = sites[vertex];
    Sphere<D> sphere;
    std::copy_n(site.x, D, sphere.x.begin());
    sphere.weight = site.weight;
    sphere.radius = std::sqrt(std::max(0.0, site.weight + alpha2));
    spheres_[vertex] = sphere;
  }
}

template <>
ContactFacet<3> ContactFacets<3>::facet(SimplexId edge, Room& room) const {
  constexpr double kPerCell = std::numbers::pi / 3;  // its solid angle lacks pi, told by 3 edges
  const auto ends = face_vertices<2>(*filtration_, edge);
  const std::array<const Sphere<3>*, 2> ball{&spheres_[ends[0]], &spheres_[ends[1]]};
  const LensFrame frame(*ball[0], *ball[1]);
  ContactFacet<3> facet;
  facet.lens = frame.lens();
  look_around(*filtration_, index_, edge, ends, room);
  const bool is_interior = filtration_->interior(edge) <= index_;

  double inside = 0.0;  // angles of cells
  double beside = 0.0;  // of the tetrahedra beside exposed triangles
  InLens moment;
  const auto begin_or_end_arc = [&](const Chord& chord, std::uint32_t third, double side) {
    beside += chord.half_angle();
    const InLens corner = chord.end(side);
    moment.x -= side * corner.y;
    moment.y += side * corner.x;
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      if (tells_better(facet.lens, *ball[end], ends[1 - end], spheres_[third], third,
                       ends[end] < third)) {
        facet.taken[end] += frame.solid_angle(chord, end, ball[end]->radius);
      }
    }
    return corner;
  };

  const std::size_t size = room.size();
  Chord next = size == 0 || !room[0].is_in ? Chord{} : frame.chord(spheres_[room[0].vertex]);
  const Chord first = next;
  InLens corner;  // of the facet, at the end of the last chord that has been met
  if (size > 0 && room[size - 1].cell_is_in) {
    corner = frame.crossing(frame.chord(spheres_[room[size - 1].vertex]), first);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const Chord chord = next;
    const bool is_last = i + 1 == size;
    const std::size_t after = is_last ? 0 : i + 1;
    if (room[after].is_in) next = is_last ? first : frame.chord(spheres_[room[after].vertex]);
    if (!room[i].is_in) continue;
    const bool follows_cell = room[i == 0 ? size - 1 : i - 1].cell_is_in;
    if (!follows_cell) corner = begin_or_end_arc(chord, room[i].vertex, -1.0);
    InLens end;
    if (room[i].cell_is_in) {
      end = frame.crossing(chord, next);
      if (!is_interior) inside += angle_between(chord.apex, next.apex);
      for (double& taken : facet.taken) taken -= kPerCell;
    } else {
      end = begin_or_end_arc(chord, room[i].vertex, 1.0);
    }
    facet.area += cross(corner, end) / 2;
    corner = end;
  }
  constexpr double kAll = 2 * std::numbers::pi;
  if (is_interior) inside = kAll;
  facet.exposed = is_interior ? 0.0 : std::max(0.0, kAll - inside - beside);
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    const double r = ball[end]->radius;
    facet.taken[end] += inside;
    if (r > 0.0) facet.taken[end] += (r - facet.lens.height[end]) / r * facet.exposed;
  }
  facet.area = std::max(0.0, facet.area + facet.lens.radius2 * facet.exposed / 2);
  facet.moment = frame.in_space(moment);
  return facet;
}

template <>
ContactFacet<2> ContactFacets<2>::facet(SimplexId edge, Room& /*room*/) const {
  const auto ends = face_vertices<2>(*filtration_, edge);
  const std::array<const Sphere<2>*, 2> ball{&spheres_[ends[0]], &spheres_[ends[1]]};
  ContactFacet<2> facet;
  facet.lens = lens(*ball[0], *ball[1]);
  const auto& axis = facet.lens.axis;
  facet.exposed = 2.0;
  double across = 0.0;  // of the exposed points, to the left
  double length = 2 * facet.lens.radius;
  if (filtration_->triangulation().affine_dimension() == 2) {
    for (const SimplexId triangle : filtration_->cells_beside(edge)) {
      if (!is_in(triangle)) continue;
      for (const VertexId vertex : filtration_->vertices(triangle)) {
        if (vertex.row() == ends[0] || vertex.row() == ends[1]) continue;
        const Sphere<2>& third = spheres_[vertex.row()];
        const double x = third.x[0] - ball[0]->x[0], y = third.x[1] - ball[0]->x[1];
        facet.exposed -= 1.0;
        across -= axis[0] * y - axis[1] * x > 0.0 ? facet.lens.radius : -facet.lens.radius;
        length += offset_across(facet.lens, *ball[0], third) - facet.lens.radius;
        // Two edges of the triangle tell each of its angles.
        facet.taken[0] += corner_angle(*ball[0], *ball[1], third) / 2;
        facet.taken[1] += corner_angle(*ball[1], *ball[0], third) / 2;
      }
    }
  }
  facet.area = std::max(0.0, length);
  facet.moment = {-axis[1] * across, axis[0] * across};
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    facet.taken[end] += facet.exposed * facet.lens.opening(end);
  }
  return facet;
}

template class ContactFacets<2>;
template class ContactFacets<3>;

}  // namespace orthoball
