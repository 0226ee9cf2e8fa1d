// SPDX-License-Identifier: MIT
//
// At an index, the loops that are closed by edges whose tunnels live there are a basis of the
// homology. Every edge gets the part of it that it stands for: an edge that joins components none,
// one whose tunnel lives itself, one whose loop is filled the parts of the other edges of its
// chain, all of which come before it. Then the sum over the edges of a cycle is its homology class.
//
// The tunnel of an edge is the class of its chain, in which the edge itself comes last. A class is
// free if it is a sum of tunnels that are born before the one that is looked for and die before it:
// taking its last edge's tunnel away, time and again, leaves nothing. A cycle is born and dies with
// the tunnel if the two differ by a free class.
//
// Busaryev, Cabello, Chen, Dey, Wang. Annotating simplices with a homology basis and its
// applications. SWAT 2012. Erickson, Whittlesey. Greedy optimal homotopy and homology generators.
// SODA 2005, for loops made of a tree of shortest paths and an edge.
#include "orthoball/queries/tunnel_cycles.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <queue>

#include "orthoball/filtration/edge_ring.h"
#include "orthoball/filtration/face_vertices.h"
#include "orthoball/queries/edge_rings.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = TunnelReduction::kNone;
constexpr std::size_t kRoots = 12;  // of new trees on a loop that was found
constexpr int kRounds = 6;

std::vector<std::uint32_t> sum(const std::vector<std::uint32_t>& a,
                               const std::vector<std::uint32_t>& b) {
  std::vector<std::uint32_t> result;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

bool has(const std::vector<std::uint32_t>& chain, std::uint32_t edge) {
  return std::binary_search(chain.begin(), chain.end(), edge);
}

void flip(std::vector<std::uint32_t>& chain, std::uint32_t edge) {
  const auto place = std::lower_bound(chain.begin(), chain.end(), edge);
  if (place != chain.end() && *place == edge) {
    chain.erase(place);
  } else {
    chain.insert(place, edge);
  }
}

std::vector<bool> marked(std::size_t count, const KeyedSimplices& simplices,
                         const std::vector<PersistencePair>& pairs, bool births) {
  std::vector<bool> result(count, false);
  for (const PersistencePair& pair : pairs) {
    const SimplexId simplex = births ? pair.birth : pair.death;
    if (simplex.exists()) result[simplices.number(simplex)] = true;
  }
  return result;
}

}  // namespace

template <int D>
EdgesAtVertices::EdgesAtVertices(const Filtration<D>& filtration)
    : first_(filtration.count(0) + 1, 0), ways_(2 * filtration.count(1)) {
  const KeyedSimplices edges(filtration, 1);
  for (std::uint32_t edge = 0; edge < edges.count(); ++edge) {
    for (const std::uint32_t end : face_vertices<2>(filtration, edges.id(edge))) ++first_[end + 1];
  }
  for (std::size_t vertex = 1; vertex < first_.size(); ++vertex) {
    first_[vertex] += first_[vertex - 1];
  }
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t edge = 0; edge < edges.count(); ++edge) {
    const auto [v, w] = face_vertices<2>(filtration, edges.id(edge));
    ways_[next[v]++] = {edge, w};
    ways_[next[w]++] = {edge, v};
  }
}
template EdgesAtVertices::EdgesAtVertices(const Filtration<2>&);
template EdgesAtVertices::EdgesAtVertices(const Filtration<3>&);

TunnelCycles::TunnelCycles(const Filtration<3>& filtration, const PersistencePairs<3>& all,
                           const EdgesAtVertices& ways, std::vector<double> lengths)
    : filtration_(filtration),
      ways_(ways),
      lengths_(std::move(lengths)),
      edges_(filtration, 1),
      triangles_(filtration, 2),
      joins_(marked(edges_.count(), edges_, all[0], false)),
      cuts_(marked(triangles_.count(), triangles_, all[2], true)),
      reduction_(filtration, joins_, cuts_) {}

std::pair<std::uint32_t, std::uint32_t> TunnelCycles::ends(std::uint32_t edge) const {
  const auto vertices = face_vertices<2>(filtration_, edges_.id(edge));
  return {vertices[0], vertices[1]};
}

const TunnelCycles::Edges& TunnelCycles::class_of(std::uint32_t edge) {
  std::vector<std::uint32_t> open{edge};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    if (classes_.count(at) > 0) {
      open.pop_back();
      continue;
    }
    Edges of_class;
    if (lives(at)) {
      of_class.push_back(at);
    } else if (!joins_[at]) {
      const std::size_t known = open.size();
      reduction_.for_each_before(at, [&](std::uint32_t other) {
        if (classes_.count(other) == 0) open.push_back(other);
      });
      if (open.size() > known) continue;
      reduction_.for_each_before(
          at, [&](std::uint32_t other) { of_class = sum(of_class, classes_[other]); });
    }
    classes_[at] = std::move(of_class);
  }
  return classes_[edge];
}

bool TunnelCycles::lives(std::uint32_t edge) const {
  return !joins_[edge] && triangles_.enters(reduction_.filled_by(edge)) > index_;
}

// The class of the chain of an edge.
const TunnelCycles::Edges& TunnelCycles::tunnel_of(std::uint32_t edge) {
  const auto known = tunnels_.find(edge);
  if (known != tunnels_.end()) return known->second;
  Edges tunnel = class_of(edge);
  reduction_.for_each_before(edge,
                             [&](std::uint32_t other) { tunnel = sum(tunnel, class_of(other)); });
  return tunnels_[edge] = std::move(tunnel);
}

std::uint32_t TunnelCycles::last_of(const Edges& edges) const {
  return *std::max_element(edges.begin(), edges.end(), [&](std::uint32_t a, std::uint32_t b) {
    return edges_.key(a) < edges_.key(b);
  });
}

// Whether the tunnel of an edge is born before and dies before the one that is looked for.
bool TunnelCycles::is_free(std::uint32_t edge) const {
  return edges_.key(edge) < edges_.key(birth_) &&
         triangles_.key(reduction_.filled_by(edge)) < triangles_.key(reduction_.filled_by(birth_));
}

bool TunnelCycles::is_free_class(Edges of_class) {
  while (!of_class.empty()) {
    const std::uint32_t last = last_of(of_class);
    if (!is_free(last)) return false;
    of_class = sum(of_class, tunnel_of(last));
  }
  return true;
}

TunnelCycles::Edges TunnelCycles::way_back(const Tree& tree, std::uint32_t vertex) const {
  Edges edges;
  for (auto at = tree.find(vertex); at->second.edge != kNone; at = tree.find(at->second.from)) {
    edges.push_back(at->second.edge);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Grows a tree of shortest paths while it can make a loop shorter than the best.
void TunnelCycles::look_from(std::uint32_t root, const Edges& wanted, Loop& best) {
  // A loop that differs from what is wanted in its last edge is not wanted, if that is not free.
  const std::uint32_t last = last_of(wanted);
  const bool is_needed = !is_free(last);
  Tree tree;
  using Front = std::pair<double, std::uint32_t>;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
  tree[root] = {0.0, kNone, root, false, {}};
  front.emplace(0.0, root);
  std::array<std::uint32_t, 3> closing{kNone, kNone, kNone};  // the edge and its ends
  while (!front.empty()) {
    const auto [distance, vertex] = front.top();
    front.pop();
    if (2 * distance >= best.length) break;
    Reached& here = tree[vertex];
    if (here.is_settled) continue;
    here.is_settled = true;
    if (here.edge != kNone) here.of_class = sum(tree[here.from].of_class, class_of(here.edge));
    const std::uint32_t came_by = here.edge;
    for (const auto& [edge, to] : ways_.of(vertex)) {
      if (!is_in(edge) || edge == came_by) continue;
      const double on = distance + lengths_[edge];
      const auto there = tree.find(to);
      if (there != tree.end() && there->second.is_settled) {
        const double length = on + there->second.distance;
        if (!(length < best.length)) continue;
        const Edges &here_class = tree[vertex].of_class, &there_class = there->second.of_class;
        const Edges& of_edge = class_of(edge);
        if (is_needed && (has(here_class, last) != has(there_class, last)) == has(of_edge, last)) {
          continue;
        }
        if (!is_free_class(sum(sum(sum(here_class, of_edge), there_class), wanted))) continue;
        best.length = length;
        closing = {edge, vertex, to};
      } else if (there == tree.end() || on < there->second.distance) {
        tree[to] = {on, edge, vertex, false, {}};
        front.emplace(on, to);
      }
    }
  }
  if (closing[0] == kNone) return;
  best.edges = sum(way_back(tree, closing[1]), way_back(tree, closing[2]));
  flip(best.edges, closing[0]);
  best.length = 0.0;  // the paths may have begun with the same edges
  for (const std::uint32_t edge : best.edges) best.length += lengths_[edge];
}

// Every vertex's way along joining edges to the first vertex of its component.
void TunnelCycles::root_forest() {
  if (!depth_.empty()) return;
  depth_.assign(filtration_.count(0), kNone);
  towards_root_.assign(filtration_.count(0), kNone);
  for (std::uint32_t root = 0; root < depth_.size(); ++root) {
    if (depth_[root] != kNone) continue;
    depth_[root] = 0;
    std::vector<std::uint32_t> front{root};
    while (!front.empty()) {
      const std::uint32_t vertex = front.back();
      front.pop_back();
      for (const auto& [edge, to] : ways_.of(vertex)) {
        if (!joins_[edge] || depth_[to] != kNone) continue;
        depth_[to] = depth_[vertex] + 1;
        towards_root_[to] = edge;
        front.push_back(to);
      }
    }
  }
}

// The chain that is filled when the tunnel is: its edges that close loops, each with the way
// between its ends along edges that join.
TunnelCycles::Edges TunnelCycles::chain_of(std::uint32_t birth_edge) {
  root_forest();
  Edges chain;
  const auto add_loop = [&](std::uint32_t edge) {
    flip(chain, edge);
    auto [v, w] = ends(edge);
    const auto step = [&](std::uint32_t& vertex) {
      const std::uint32_t along = towards_root_[vertex];
      flip(chain, along);
      const auto [a, b] = ends(along);
      vertex = a == vertex ? b : a;
    };
    while (v != w) depth_[v] > depth_[w] ? step(v) : step(w);
  };
  add_loop(birth_edge);
  reduction_.for_each_before(birth_edge, add_loop);
  return chain;
}

// Takes the third edge of a triangle of the complex for the two others.
bool TunnelCycles::shorten_once(Edges& edges) const {
  const auto cells = filtration_.triangulation().cells<3>();
  const auto& table = filtration_.table();
  for (const std::uint32_t edge : edges) {
    const std::uint32_t owner = table.edge_owners()[edge];
    std::uint32_t found = kNone;
    for_each_around_edge(cells, owner / 6, owner % 6, [&](std::uint32_t cell, unsigned slot) {
      for (const unsigned corner : kEdgeCorners[5 - slot]) {
        const std::uint32_t triangle = table.facet_of_cell<3>(cells, cell, corner);
        if (found != kNone || triangles_.enters(triangle) > index_) continue;
        const auto sides = reduction_.boundaries().edges(triangle);
        const auto count = std::count_if(sides.begin(), sides.end(), [&](std::uint32_t side) {
          return std::binary_search(edges.begin(), edges.end(), side);
        });
        if (count >= 2) found = triangle;
      }
    });
    if (found == kNone) continue;
    for (const std::uint32_t side : reduction_.boundaries().edges(found)) flip(edges, side);
    return true;
  }
  return false;
}

// Every time there is one edge less at least.
void TunnelCycles::shorten(Edges& edges) const {
  while (shorten_once(edges)) {
  }
}

// From vertices all along a loop, until none finds a shorter one.
void TunnelCycles::tighten(const Edges& wanted, Loop& best) {
  for (int round = 0; round < kRounds; ++round) {
    const Loop before = best;
    const std::size_t step = std::max<std::size_t>(1, before.edges.size() / kRoots);
    for (std::size_t i = 0; i < before.edges.size(); i += step) {
      look_from(ends(before.edges[i]).first, wanted, best);
    }
    if (!(best.length < before.length)) break;
  }
}

// A cycle ring by ring: those of a free class are left out, others made shorter.
TunnelCycles::Edges TunnelCycles::tightened(const Edges& cycle) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> edge_between;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const std::uint32_t edge : cycle) {
    const auto [v, w] = ends(edge);
    pairs.push_back({v, w});
    edge_between[pairs.back()] = edge;
  }
  Edges result;
  for (const auto& vertices : edge_rings(pairs)) {
    Loop ring{0.0, {}};
    Edges of_class;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const auto [low, high] = std::minmax(vertices[i], vertices[(i + 1) % vertices.size()]);
      const std::uint32_t edge = edge_between[{low, high}];
      flip(ring.edges, edge);
      ring.length += lengths_[edge];
      of_class = sum(of_class, class_of(edge));
    }
    if (is_free_class(of_class)) continue;
    tighten(of_class, ring);
    result = sum(result, ring.edges);
  }
  return result;
}

std::vector<std::uint32_t> TunnelCycles::cycle(std::uint32_t birth_edge, std::uint32_t index) {
  if (index != index_) {
    classes_.clear();
    tunnels_.clear();
  }
  birth_ = birth_edge;
  index_ = index;
  const Edges wanted = tunnel_of(birth_edge);
  Loop best{std::numeric_limits<double>::infinity(), {}};
  const auto [v, w] = ends(birth_edge);
  look_from(v, wanted, best);
  look_from(w, wanted, best);
  if (best.edges.empty()) {
    Edges chain = chain_of(birth_edge);
    shorten(chain);
    return tightened(chain);
  }
  tighten(wanted, best);
  return best.edges;
}

}  // namespace orthoball
