// SPDX-License-Identifier: MIT
#include "orthoball/measures/probes_at_rest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "orthoball/measures/ball_part.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// Probes nearer to each other than this many radii may be one point, found from two triangles.
constexpr double kSamePlace = 1e-7;

struct Probe {
  FromCentre centre{};
  std::array<std::uint32_t, 3> corners{};  // of the triangle, counterclockwise seen from its side
  double height = 0.0;                     // over the triangle
  std::uint32_t behind = kOutside;         // the cell of the complex there
};

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// [place]: an ascending list for each, one after the other.
struct Lists {
  std::vector<std::uint32_t> begins, entries;
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t place) const {
    return std::span(entries).subspan(begins[place], begins[place + 1] - begins[place]);
  }
};

// Of the second numbers by the first.
Lists lists_of(const Pairs& pairs, std::size_t places) {
  std::vector<std::uint32_t> ends(places + 1, 0);
  for (const auto& pair : pairs) ++ends[pair.first + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::uint32_t> all(pairs.size());
  const std::vector<std::uint32_t> begins = ends;
  for (const auto& [place, entry] : pairs) all[ends[place]++] = entry;
  Lists lists;
  lists.begins.push_back(0);
  for (std::size_t place = 0; place < places; ++place) {
    const auto begin = all.begin() + begins[place], end = all.begin() + ends[place];
    std::sort(begin, end);
    lists.entries.insert(lists.entries.end(), begin, std::unique(begin, end));
    lists.begins.push_back(static_cast<std::uint32_t>(lists.entries.size()));
  }
  return lists;
}

template <int A>
void add_edges(const RegularTriangulation<3>& triangulation, Pairs& edges) {
  const Sites<3>& sites = triangulation.sites();
  for (const CellRecord<A>& cell : triangulation.cells<A>()) {
    for (const std::uint32_t a : cell.corners) {
      for (const std::uint32_t b : cell.corners) {
        if (a != b) edges.emplace_back(sites.row(a).row(), sites.row(b).row());
      }
    }
  }
}

double distance2(const FromCentre& a, const FromCentre& b) {
  const FromCentre way = difference(b, a);
  return inner(way, way);
}

class ProbesAtRest {
 public:
  ProbesAtRest(const Filtration<3>& filtration, std::uint32_t index,
               std::span<const Sphere<3>> spheres, double radius)
      : filtration_(filtration),
        cells_(filtration.triangulation().cells<3>()),
        index_(index),
        spheres_(spheres),
        radius_(radius) {}

  std::vector<ProbePart> parts(Threads threads) {
    find_probes();
    find_reaching(threads);
    std::vector<ProbePart> parts(probes_.size());
    constexpr std::size_t kPart = 256;
    parallel_parts(threads, probes_.size(), probes_.size() / kPart + 1,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) parts[i] = over_triangle(probes_[i]);
                   });
    std::vector<ProbePart> behind(reaching_.size());
    parallel_parts(threads, reaching_.size(), reaching_.size() / kPart + 1,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) behind[i] = in_cells(i);
                   });
    parts.insert(parts.end(), behind.begin(), behind.end());
    return parts;
  }

 private:
  [[nodiscard]] bool is_in(SimplexId simplex) const {
    return filtration_.enters(simplex) <= index_;
  }
  [[nodiscard]] bool cell_is_in(std::uint32_t cell) const {
    return is_in(SimplexId(filtration_.table().first(3) + cell));
  }
  void find_probes();
  void add_probe(std::array<std::uint32_t, 3> corners, std::uint32_t behind);
  void find_reaching(Threads threads);
  [[nodiscard]] ProbePart over_triangle(const Probe& probe) const;
  [[nodiscard]] ProbePart in_cells(std::size_t i) const;

  const Filtration<3>& filtration_;
  std::span<const CellRecord<3>> cells_;
  std::uint32_t index_;
  std::span<const Sphere<3>> spheres_;
  double radius_;
  std::vector<Probe> probes_;
  std::vector<Probe> reaching_;       // those that reach into a cell of the complex
  Lists beside_;                      // [reaching]: those whose parts may touch its part
  std::vector<std::uint32_t> group_;  // [reaching]: those at the same place, told by the first
  Lists groups_;                      // [group]: the members
  std::vector<bool> is_twin_;         // [reaching]: another is exactly there, and has all
};

void ProbesAtRest::find_probes() {
  const SimplexTable<3>& table = filtration_.table();
  // The corners of a facet, by the corner left out, counterclockwise seen from outside.
  constexpr std::array<std::array<std::uint8_t, 3>, 4> kOutward{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  for (std::uint32_t i = 0; i < filtration_.count(2); ++i) {
    const SimplexId triangle(table.first(2) + i);
    if (!is_in(triangle) || filtration_.interior(triangle) <= index_) continue;
    std::array<std::uint32_t, 3> corners{};
    if (cells_.empty()) {
      const auto vertices = filtration_.vertices(triangle);
      for (std::size_t k = 0; k < 3; ++k) corners[k] = vertices[k].row();
      add_probe(corners, kOutside);
      add_probe({corners[0], corners[2], corners[1]}, kOutside);
      continue;
    }
    const std::uint32_t owner = table.facet_owners()[i];
    const CellRecord<3>& record = cells_[owner / 4];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = record.corners[kOutward[owner % 4][k]];
    const std::uint32_t beyond = record.neighbours[owner % 4];
    const bool own_is_in = cell_is_in(owner / 4);
    const bool beyond_is_in = beyond != kOutside && cell_is_in(beyond / 4);
    if (!beyond_is_in) add_probe(corners, own_is_in ? owner / 4 : kOutside);
    if (!own_is_in) {
      add_probe({corners[0], corners[2], corners[1]}, beyond_is_in ? beyond / 4 : kOutside);
    }
  }
}

// The centre is told in the frame of the edge with the smallest circle.
void ProbesAtRest::add_probe(std::array<std::uint32_t, 3> corners, std::uint32_t behind) {
  std::array<double, 3> circle2{};
  for (std::size_t i = 0; i < 3; ++i) {
    circle2[i] = rough_circle2(spheres_[corners[i]], spheres_[corners[(i + 1) % 3]]);
  }
  std::array<std::uint32_t, 3> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  std::rotate(
      corners.begin(),
      corners.begin() + (std::min_element(circle2.begin(), circle2.end()) - circle2.begin()),
      corners.end());
  const Sphere<3>& first = spheres_[corners[0]];
  const LensFrame frame(first, spheres_[corners[1]]);
  const double height =
      meeting_height(spheres_[sorted[0]], spheres_[sorted[1]], spheres_[sorted[2]]);
  const Chord chord = frame.chord(frame.beyond(spheres_[corners[2]]), height);
  const std::array<double, 3> across = frame.in_space(chord.end(1.0));
  Probe probe{{}, corners, height, behind};
  for (std::size_t i = 0; i < 3; ++i) {
    probe.centre[i] = first.x[i] + frame.lens().height[0] * frame.lens().axis[i] + across[i];
  }
  probes_.push_back(probe);
}

// Neighbours among them are told by their Delaunay triangulation.
void ProbesAtRest::find_reaching(Threads threads) {
  for (const Probe& probe : probes_) {
    if (probe.behind != kOutside && probe.height < radius_) reaching_.push_back(probe);
  }
  std::vector<double> coordinates;
  for (const Probe& probe : reaching_) {
    coordinates.insert(coordinates.end(), probe.centre.begin(), probe.centre.end());
  }
  const RegularTriangulation<3> triangulation = regular_triangulation<3>(
      WeightedPoints(3, std::move(coordinates), WeightKind::none, {}), threads);
  Pairs edges;
  add_edges<1>(triangulation, edges);
  add_edges<2>(triangulation, edges);
  add_edges<3>(triangulation, edges);
  beside_ = lists_of(edges, reaching_.size());
  group_.resize(reaching_.size());
  std::iota(group_.begin(), group_.end(), 0U);
  const auto first_of = [&](std::uint32_t place) {
    while (group_[place] != place) place = group_[place] = group_[group_[place]];
    return place;
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    a = first_of(a);
    b = first_of(b);
    group_[std::max(a, b)] = std::min(a, b);
  };
  is_twin_.assign(reaching_.size(), false);
  for (const Duplicate& twin : triangulation.duplicates()) {
    is_twin_[twin.row.row()] = true;
    join(twin.row.row(), twin.representative.row());
  }
  const double near2 = kSamePlace * kSamePlace * radius_ * radius_;
  for (const auto& [a, b] : edges) {
    if (distance2(reaching_[a].centre, reaching_[b].centre) < near2) join(a, b);
  }
  Pairs members;
  for (std::uint32_t i = 0; i < reaching_.size(); ++i) {
    group_[i] = first_of(i);
    members.emplace_back(group_[i], i);
  }
  groups_ = lists_of(members, reaching_.size());
}

ProbePart ProbesAtRest::over_triangle(const Probe& probe) const {
  std::array<FromCentre, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = difference(spheres_[probe.corners[i]].x, probe.centre);
  const FromCentre along = difference(corners[1], corners[0]),
                   to = difference(corners[2], corners[0]);
  FromCentre normal = cross_product(along, to);
  const double norm = std::sqrt(inner(normal, normal));
  if (!(norm > 0.0 && radius_ > 0.0)) return {};
  for (double& x : normal) x /= norm;
  ConePart sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const ConePart part =
        cone_over_edge(corners[i], corners[(i + 1) % 3], normal, probe.height, radius_);
    sum.disk += part.disk;
    sum.solid_angle += part.solid_angle;
  }
  return {sum.volume(probe.height, radius_), sum.solid_angle};
}

// All points of the part are seen from the probe within it, so it is found by going through faces
// that it meets.
ProbePart ProbesAtRest::in_cells(std::size_t i) const {
  // Of the probe's disk: what rounding leaves of a face that the ball does not meet is less.
  constexpr double kNothing = 1e-14;
  if (is_twin_[i]) return {};
  const FromCentre centre = reaching_[i].centre;
  ProbePart sum;
  std::vector<std::uint32_t> found;
  std::unordered_set<std::uint32_t> known;
  const auto find = [&](std::uint32_t cell) {
    if (known.insert(cell).second) found.push_back(cell);
  };
  for (const std::uint32_t member : groups_[group_[i]]) find(reaching_[member].behind);
  for (std::size_t next = 0; next < found.size(); ++next) {
    const CellRecord<3>& record = cells_[found[next]];
    std::array<FromCentre, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = difference(spheres_[record.corners[k]].x, centre);
    CutTetrahedron cell(corners, record.corners);
    for (const std::uint32_t other : beside_[i]) {
      FromCentre way = difference(reaching_[other].centre, centre);
      const double length = std::sqrt(inner(way, way));
      if (!(length > 0.0 && length < 2 * radius_)) continue;
      for (double& x : way) x /= length;
      cell.cut(way, length / 2);
    }
    for (std::size_t k = 0; k < cell.face_count(); ++k) {
      const CutTetrahedron::Face face = cell.face(k, radius_);
      sum.volume += face.sign * face.part.volume(face.height, radius_);
      sum.solid_angle += face.sign * face.part.solid_angle;
      if (k >= 4 || !(face.part.disk > kNothing * radius_ * radius_)) continue;
      const std::uint32_t beyond = record.neighbours[k];
      if (beyond != kOutside && cell_is_in(beyond / 4)) find(beyond / 4);
    }
  }
  return sum;
}

}  // namespace

std::vector<ProbePart> probes_at_rest(const Filtration<3>& filtration, std::uint32_t index,
                                      std::span<const Sphere<3>> spheres, double radius,
                                      Threads threads) {
  return ProbesAtRest(filtration, index, spheres, radius).parts(threads);
}

}  // namespace orthoball
