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

// The third vertices of the triangles around an edge, counterclockwise about it; those of the hull
// first and last where it is on the hull.
template <class IsIn>
void look_around(const Filtration<3>& filtration, SimplexId edge, bool is_interior,
                 std::array<std::uint32_t, 2> ends, const IsIn& is_in,
                 std::vector<ApexOfEdge>& room) {
  room.clear();
  const SimplexTable<3>& table = filtration.table();
  const auto cells = filtration.triangulation().cells<3>();
  if (cells.empty()) {
    if (filtration.triangulation().affine_dimension() != 2) return;
    for (const SimplexId triangle : filtration.cells_beside(edge)) {
      for (const VertexId vertex : filtration.vertices(triangle)) {
        if (vertex.row() != ends[0] && vertex.row() != ends[1]) {
          room.push_back({vertex.row(), is_in(triangle), false, triangle.row() - table.first(2)});
        }
      }
    }
    return;
  }
  const std::uint32_t owner = table.edge_owners()[edge.row() - table.first(1)];
  const auto& turn = kTurn[owner % 6];
  Turn start{owner / 6, turn[2], turn[3]};
  if (cells[start.cell].corners[turn[0]] != ends[0]) std::swap(start.behind, start.ahead);

  const auto cell_is_in = [&](std::uint32_t cell) {
    return is_interior || is_in(SimplexId(table.first(3) + cell));
  };
  const auto apex_of = [&](std::uint32_t vertex, bool before, bool after, std::uint32_t cell,
                           unsigned left_out) {
    if (before && after) return ApexOfEdge{vertex, true, true, 0};
    const std::uint32_t facet = table.facet_of_cell(cells, cell, left_out);
    return ApexOfEdge{vertex, before || after || is_in(SimplexId(table.first(2) + facet)), after,
                      facet};
  };
  Turn last = start;
  const auto push = [&](const Turn& at) {
    const bool before = !room.empty() && room.back().cell_is_in;
    const bool after = cell_is_in(at.cell);
    room.push_back(apex_of(cells[at.cell].corners[at.behind], before, after, at.cell, at.ahead));
    last = at;
  };
  if (turn_on(cells, start, push)) return;
  // Back from the start to the hull, which is to turn the other way, and then all of it from there.
  room.clear();
  turn_on(cells, Turn{start.cell, start.ahead, start.behind}, [&](const Turn& at) { last = at; });
  start = {last.cell, last.ahead, last.behind};
  turn_on(cells, start, push);
  room.push_back(apex_of(cells[last.cell].corners[last.ahead], room.back().cell_is_in, false,
                         last.cell, last.behind));
}

}  // namespace

template <int D>
ContactFacets<D>::ContactFacets(const Filtration<D>& filtration, std::uint32_t index, double alpha2,
                                Threads threads)
    : filtration_(&filtration), index_(index), balls_(filtration, index, alpha2) {
  const std::span<const std::uint32_t> enters = filtration.enters();
  is_in_complex_.resize(enters.size() / 64 + 1);
  for (std::size_t word = 0; word < is_in_complex_.size(); ++word) {
    const std::size_t first = 64 * word, size = std::min<std::size_t>(64, enters.size() - first);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      bits |= std::uint64_t{enters[first + i] <= index} << i;
    }
    is_in_complex_[word] = bits;
  }
  find_heights(threads);
}

template <>
void ContactFacets<2>::find_heights(Threads /*threads*/) {}

template <>
void ContactFacets<3>::find_heights(Threads threads) {
  constexpr std::size_t kPart = std::size_t{1} << 13U;
  const std::uint32_t first = filtration_->table().first(2);
  const std::size_t triangles = filtration_->count(2);
  heights_.resize(triangles);
  parallel_parts(threads, triangles, triangles / kPart + 1,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const SimplexId triangle(first + static_cast<std::uint32_t>(i));
                     if (!is_in(triangle) || is_interior(triangle)) continue;
                     const auto corners = face_vertices<3>(*filtration_, triangle);
                     heights_[i] = meeting_height(spheres()[corners[0]], spheres()[corners[1]],
                                                  spheres()[corners[2]]);
                   }
                 });
}

namespace {

// What angles of an edge are summed for.
using Sum = std::uint32_t;
constexpr Sum kInside = 0;   // of the cells around it
constexpr Sum kBeside = 1;   // of the tetrahedra beside exposed triangles
constexpr Sum kTaken = 2;    // solid angles of these at the two ends
constexpr Sum kOpening = 4;  // of the circle, seen from the two centres
constexpr Sum kSums = 6;

// Looks around edges in space, one by one: everything about them but the angles, for which it asks.
class EdgeInSpace {
 public:
  using Room = ContactFacets<3>::Room;

  EdgeInSpace(std::span<const Sphere<3>> spheres, std::span<const double> heights,
              const std::array<std::uint32_t, 2>& ends, bool is_interior, std::uint32_t number,
              Room& room)
      : spheres_(spheres),
        heights_(heights),
        ends_(ends),
        room_(room),
        first_sum_(kSums * number),
        is_interior_(is_interior),
        frame_(spheres[ends[0]], spheres[ends[1]]),
        circle_(rough_circle2(spheres[ends[0]], spheres[ends[1]])) {}

  // Without the disk's sectors at the arcs.
  void look_at(ContactFacet<3>& facet) {
    facet = {};
    facet.ends = ends_;
    facet.lens = frame_.lens();
    const std::span<const ApexOfEdge> around = room_.around;
    const std::size_t size = around.size();
    make_room(kAnglesPerApex * size + kSums);
    Beyond next = size > 0 && around[0].is_in ? beyond(around[0]) : Beyond{};
    const Beyond first = next;
    InLens corner;  // of the facet, at the end of the last line that has been met
    if (size > 0 && around[size - 1].cell_is_in) {
      corner = frame_.crossing(beyond(around[size - 1]), first);
    }
    bool follows_cell = size > 0 && around[size - 1].cell_is_in;
    for (std::size_t i = 0; i < size; ++i) {
      const ApexOfEdge& apex = around[i];
      const Beyond here = next;
      const std::size_t after = i + 1 == size ? 0 : i + 1;
      if (around[after].is_in) next = after == 0 ? first : beyond(around[after]);
      if (apex.is_in) {
        InLens end;
        if (apex.cell_is_in) {
          end = frame_.crossing(here, next);
          ++cells_;
          if (!is_interior_) ask(kInside, angle_between(here.apex, next.apex), 1.0);
        }
        if (!follows_cell || !apex.cell_is_in) {
          const Chord chord = frame_.chord(here, heights_[apex.facet]);
          const double sides = expose(chord, apex, follows_cell, corner, end);
          facet.pieces += sides * facet.lens.distance * chord.apex_distance * chord.half / 18;
        }
        facet.area += cross(corner, end) / 2;
        corner = end;
      }
      follows_cell = apex.cell_is_in;
    }
    // The solid angle of a cell lacks pi of its three angles, of which this edge has one.
    facet.taken.fill(-std::numbers::pi / 3 * cells_);
    facet.moment = frame_.in_space(moment_);
    if (is_interior_) return;
    ask(kOpening, facet.lens.opening(0), 1.0);
    ask(kOpening + 1, facet.lens.opening(1), 1.0);
  }

 private:
  [[nodiscard]] Beyond beyond(const ApexOfEdge& apex) const {
    return frame_.beyond(spheres_[apex.vertex]);
  }
  static constexpr std::size_t kAnglesPerApex = 4;
  void make_room(std::size_t angles) {
    const std::size_t size = room_.angle_count + angles;
    if (size <= room_.x.size()) return;
    for (auto* list : {&room_.x, &room_.y, &room_.times, &room_.angles}) list->resize(2 * size);
    room_.added_to.resize(2 * size);
  }
  // For an angle, or for none: without a branch.
  void ask(std::uint32_t sum, HalfPlane angle, double times, bool is_wanted = true) {
    const std::size_t place = room_.angle_count;
    room_.angle_count += is_wanted ? 1U : 0U;
    room_.x[place] = angle.x;
    room_.y[place] = angle.y;
    room_.times[place] = times;
    room_.added_to[place] = first_sum_ + sum;
  }

  // A triangle with one exposed side, or two, which it returns: there the facet has corners on the
  // circle.
  double expose(const Chord& chord, const ApexOfEdge& apex, bool follows_cell, InLens& begin,
                InLens& end) {
    const auto corner_at = [&](double side) {
      const InLens corner = chord.end(side);
      moment_.x -= side * corner.y;
      moment_.y += side * corner.x;
      return corner;
    };
    if (!follows_cell) begin = corner_at(-1.0);
    if (!apex.cell_is_in) end = corner_at(1.0);
    const double sides = (follows_cell ? 0.0 : 1.0) + (apex.cell_is_in ? 0.0 : 1.0);
    ask(kBeside, chord.half_angle(), sides);
    // At each end two edges of the triangle could tell the solid angle: that with the smaller
    // circle does it best.
    const Sphere<3>& third = spheres_[apex.vertex];
    for (std::uint32_t i = 0; i < 2; ++i) {
      const Sphere<3>& centre = spheres_[ends_[i]];
      const double other =
          ends_[i] < apex.vertex ? rough_circle2(centre, third) : rough_circle2(third, centre);
      const bool is_wanted =
          (circle_ < other) | ((circle_ == other) & (ends_[1 - i] < apex.vertex));
      ask(kTaken + i, frame_.half_solid_angle(chord, i, centre.radius), 2 * sides, is_wanted);
    }
    return sides;
  }

  std::span<const Sphere<3>> spheres_;
  std::span<const double> heights_;  // [triangle]
  std::array<std::uint32_t, 2> ends_;
  Room& room_;
  std::uint32_t first_sum_;
  bool is_interior_;
  LensFrame frame_;
  double circle_;
  int cells_ = 0;
  InLens moment_;
};

}  // namespace

template <>
void ContactFacets<3>::measure(std::span<const SimplexId> edges, std::span<ContactFacet<3>> out,
                               Room& room) const {
  constexpr double kAll = 2 * std::numbers::pi;
  const auto is_in_complex = [&](SimplexId simplex) { return is_in(simplex); };
  room.angle_count = 0;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const auto ends = face_vertices<2>(*filtration_, edges[i]);
    const bool is_inside = is_interior(edges[i]);
    look_around(*filtration_, edges[i], is_inside, ends, is_in_complex, room.around);
    EdgeInSpace(spheres(), heights_, ends, is_inside, i, room).look_at(out[i]);
  }
  const std::size_t angles = room.angle_count;
  angles_from_x_axis(std::span(room.x).first(angles), std::span(room.y).first(angles),
                     std::span(room.angles).first(angles));
  room.sums.assign(kSums * edges.size(), 0.0);
  for (std::size_t i = 0; i < angles; ++i) {
    room.sums[room.added_to[i]] += room.times[i] * room.angles[i];
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ContactFacet<3>& facet = out[i];
    const double* const sums = &room.sums[kSums * i];
    const bool is_inside = is_interior(edges[i]);
    const double inside = is_inside ? kAll : sums[kInside];
    facet.exposed = is_inside ? 0.0 : std::max(0.0, kAll - inside - sums[kBeside]);
    facet.bend = is_inside ? 0.0 : std::numbers::pi - sums[kOpening] - sums[kOpening + 1];
    facet.area = std::max(0.0, facet.area + facet.lens.radius2 * facet.exposed / 2);
    facet.pieces += facet.lens.distance * facet.lens.radius2 * facet.exposed / 6;
    for (std::size_t end = 0; end < 2; ++end) {
      const double r = spheres()[facet.ends[end]].radius;
      facet.taken[end] += inside + sums[kTaken + end];
      if (r > 0.0) facet.taken[end] += (r - facet.lens.height[end]) / r * facet.exposed;
    }
  }
}

template <>
ContactFacet<2> ContactFacets<2>::in_plane(SimplexId edge) const {
  const auto ends = face_vertices<2>(*filtration_, edge);
  const std::array<const Sphere<2>*, 2> ball{&spheres()[ends[0]], &spheres()[ends[1]]};
  ContactFacet<2> facet;
  facet.ends = ends;
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
        const Sphere<2>& third = spheres()[vertex.row()];
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
  facet.pieces = facet.exposed * facet.lens.distance * facet.lens.radius / 2;
  facet.moment = {-axis[1] * across, axis[0] * across};
  const std::array<double, 2> opening{angle(facet.lens.opening(0)), angle(facet.lens.opening(1))};
  facet.bend = std::numbers::pi - opening[0] - opening[1];
  for (std::size_t end = 0; end < 2; ++end) facet.taken[end] += facet.exposed * opening[end];
  return facet;
}

template <>
void ContactFacets<2>::measure(std::span<const SimplexId> edges, std::span<ContactFacet<2>> out,
                               Room& /*room*/) const {
  for (std::size_t i = 0; i < edges.size(); ++i) out[i] = in_plane(edges[i]);
}

template class ContactFacets<2>;
template class ContactFacets<3>;

}  // namespace orthoball
