// SPDX-License-Identifier: MIT
//
// A cycle is born and dies with a tunnel if its class (EdgeClasses) and that of the tunnel's chain
// differ by a sum of tunnels that are born before and die before; such a sum is free here.
//
// Erickson, Whittlesey. Greedy optimal homotopy and homology generators. SODA 2005, for loops made
// of a tree of shortest paths and an edge.
#include "orthoball/queries/tunnel_cycles.h"

#include <algorithm>
#include <array>
#include <functional>
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
// How many vertices the trees of one cycle may reach: so many, and so many times all vertices for
// the tunnel that lives longest, a half of it for the next, a third, and so on.
constexpr std::uint64_t kReachedAtLeast = 4000;
constexpr std::uint64_t kTimesAll = 8;

}  // namespace

TunnelCycles::TunnelCycles(const Filtration<3>& filtration, const PersistencePairs<3>& all,
                           const EdgesAtVertices& ways, std::vector<double> lengths)
    : filtration_(filtration),
      ways_(ways),
      lengths_(std::move(lengths)),
      classes_(filtration, all),
      tree_(filtration.count(0)),
      is_in_chain_(filtration.count(1), false),
      rank_(filtration.count(1), 0) {
  rank_lives(all[1]);
  root_forest();
}

void TunnelCycles::rank_lives(const std::vector<PersistencePair>& tunnels) {
  std::vector<std::pair<double, std::uint32_t>> lives;  // less than 0, and the edge of birth
  for (const PersistencePair& pair : tunnels) {
    const std::uint32_t birth = filtration_.enters(pair.birth),
                        death = filtration_.enters(pair.death);
    if (birth == death) continue;
    lives.emplace_back(filtration_.alpha2(birth) - filtration_.alpha2(death),
                       classes_.edges().number(pair.birth));
  }
  std::sort(lives.begin(), lives.end());
  for (std::uint32_t i = 0; i < lives.size(); ++i) rank_[lives[i].second] = i + 1;
}

std::pair<std::uint32_t, std::uint32_t> TunnelCycles::ends(std::uint32_t edge) const {
  const auto vertices = face_vertices<2>(filtration_, classes_.edges().id(edge));
  return {vertices[0], vertices[1]};
}

double TunnelCycles::length_of(const EdgeChain& chain) const {
  double length = 0.0;
  for (const std::uint32_t edge : chain) length += lengths_[edge];
  return length;
}

void TunnelCycles::add_way_back(std::uint32_t vertex, EdgeChain& edges) const {
  for (; tree_[vertex].edge != kNone; vertex = tree_[vertex].from) {
    edges.push_back(tree_[vertex].edge);
  }
}

// Grows a tree of shortest paths while it can make a loop shorter than the best.
void TunnelCycles::look_from(std::uint32_t root, const EdgeChain& wanted, Loop& best) {
  // A loop that differs from what is wanted in its last edge is not wanted, if that is not free.
  const std::uint32_t last = classes_.last_of(wanted);
  const bool is_needed = !classes_.is_free(last, birth_);
  ++search_;
  using Front = std::pair<double, std::uint32_t>;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
  const auto reach = [&](std::uint32_t vertex, double distance, std::uint32_t edge,
                         std::uint32_t from) {
    Reached& there = tree_[vertex];
    if (there.search == search_ && !(distance < there.distance)) return;
    there.distance = distance;
    there.search = search_;
    there.edge = edge;
    there.from = from;
    there.is_settled = false;
    front.emplace(distance, vertex);
  };
  reach(root, 0.0, kNone, root);
  std::array<std::uint32_t, 3> closing{kNone, kNone, kNone};  // the edge and its ends
  while (!front.empty()) {
    const auto [distance, vertex] = front.top();
    front.pop();
    if (2 * distance >= best.length || left_ == 0) break;
    Reached& here = tree_[vertex];
    if (here.is_settled) continue;
    here.is_settled = true;
    --left_;
    here.of_class.clear();
    if (here.edge != kNone) {
      here.of_class = sum(tree_[here.from].of_class, classes_.part_of(here.edge));
    }
    for (const auto& [edge, to] : ways_.of(vertex)) {
      if (!is_in(edge)) break;
      if (edge == here.edge) continue;
      const double on = distance + lengths_[edge];
      const Reached& there = tree_[to];
      if (there.search != search_ || !there.is_settled) {
        reach(to, on, edge, vertex);
        continue;
      }
      const double length = on + there.distance;
      if (!(length < best.length)) continue;
      const EdgeChain& of_edge = classes_.part_of(edge);
      if (is_needed &&
          (has(here.of_class, last) != has(there.of_class, last)) == has(of_edge, last)) {
        continue;
      }
      EdgeChain difference = sum(sum(sum(here.of_class, of_edge), there.of_class), wanted);
      if (!classes_.is_free_class(std::move(difference), birth_)) continue;
      best.length = length;
      closing = {edge, vertex, to};
    }
  }
  if (closing[0] == kNone) return;
  EdgeChain edges{closing[0]};
  add_way_back(closing[1], edges);
  add_way_back(closing[2], edges);
  best.edges = sum_of(std::move(edges));  // the paths may have begun with the same edges
  best.length = length_of(best.edges);
}

// Every vertex's way along joining edges to the first vertex of its component.
void TunnelCycles::root_forest() {
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
        if (!classes_.joins(edge) || depth_[to] != kNone) continue;
        depth_[to] = depth_[vertex] + 1;
        towards_root_[to] = edge;
        front.push_back(to);
      }
    }
  }
}

// Along edges that join.
void TunnelCycles::add_way_between_ends(std::uint32_t edge, EdgeChain& edges) const {
  auto [v, w] = ends(edge);
  const auto step = [&](std::uint32_t& vertex) {
    const std::uint32_t along = towards_root_[vertex];
    edges.push_back(along);
    const auto [a, b] = ends(along);
    vertex = a == vertex ? b : a;
  };
  while (v != w) depth_[v] > depth_[w] ? step(v) : step(w);
}

// The chain that is filled when the tunnel is: its edges that close loops, each with the way
// between its ends along edges that join.
EdgeChain TunnelCycles::chain_of(std::uint32_t birth_edge) {
  EdgeChain edges;
  const auto add_loop = [&](std::uint32_t edge) {
    edges.push_back(edge);
    add_way_between_ends(edge, edges);
  };
  add_loop(birth_edge);
  classes_.reduction().for_each_before(birth_edge, add_loop);
  return sum_of(std::move(edges));
}

// A triangle of the complex with an edge and another of the chain at hand; kNone if there is none.
std::uint32_t TunnelCycles::shortcut(std::uint32_t edge) const {
  const auto cells = filtration_.triangulation().cells<3>();
  const auto& table = filtration_.table();
  const std::uint32_t owner = table.edge_owners()[edge];
  std::uint32_t found = kNone;
  for_each_around_edge(cells, owner / 6, owner % 6, [&](std::uint32_t cell, unsigned slot) {
    for (const unsigned corner : kEdgeCorners[5 - slot]) {
      const std::uint32_t triangle = table.facet_of_cell<3>(cells, cell, corner);
      if (found != kNone || classes_.triangles().enters(triangle) > classes_.index()) continue;
      const auto sides = classes_.reduction().boundaries().edges(triangle);
      const auto count = std::count_if(sides.begin(), sides.end(),
                                       [&](std::uint32_t side) { return is_in_chain_[side]; });
      if (count >= 2) found = triangle;
    }
  });
  return found;
}

// Takes the third edge of a triangle of the complex for the two others, time and again. A shortcut
// that was not there before has the edge that came last.
EdgeChain TunnelCycles::shortened(const EdgeChain& chain) {
  std::vector<std::uint32_t> open = chain;
  for (const std::uint32_t edge : chain) is_in_chain_[edge] = true;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!is_in_chain_[open[i]]) continue;
    const std::uint32_t triangle = shortcut(open[i]);
    if (triangle == kNone) continue;
    for (const std::uint32_t side : classes_.reduction().boundaries().edges(triangle)) {
      is_in_chain_[side] = !is_in_chain_[side];
      if (is_in_chain_[side]) open.push_back(side);
    }
  }
  EdgeChain result;
  for (const std::uint32_t edge : open) {
    if (is_in_chain_[edge]) result.push_back(edge);
    is_in_chain_[edge] = false;
  }
  std::sort(result.begin(), result.end());
  return result;
}

// From vertices all along a loop, until none finds a shorter one. Those seen have found what they
// can.
void TunnelCycles::tighten(const EdgeChain& wanted, std::set<std::uint32_t> seen, Loop& best) {
  for (int round = 0; round < kRounds; ++round) {
    const Loop before = best;
    const std::size_t step = std::max<std::size_t>(1, before.edges.size() / kRoots);
    for (std::size_t i = 0; i < before.edges.size(); i += step) {
      const std::uint32_t root = ends(before.edges[i]).first;
      if (seen.insert(root).second) look_from(root, wanted, best);
    }
    if (!(best.length < before.length)) break;
  }
}

// A cycle ring by ring: those of a free class are left out, others made shorter.
EdgeChain TunnelCycles::tightened(const EdgeChain& cycle) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> edge_between;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const std::uint32_t edge : cycle) {
    const auto [v, w] = ends(edge);
    pairs.push_back({v, w});
    edge_between[pairs.back()] = edge;
  }
  EdgeChain result;
  for (const auto& vertices : edge_rings(pairs)) {
    Loop ring{0.0, {}};
    EdgeChain of_class;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const auto [low, high] = std::minmax(vertices[i], vertices[(i + 1) % vertices.size()]);
      ring.edges.push_back(edge_between[{low, high}]);
      of_class = sum(of_class, classes_.part_of(ring.edges.back()));
    }
    if (classes_.is_free_class(of_class, birth_)) continue;
    std::sort(ring.edges.begin(), ring.edges.end());
    ring.length = length_of(ring.edges);
    tighten(of_class, {}, ring);
    result = sum(result, ring.edges);
  }
  return result;
}

EdgeChain TunnelCycles::cycle(std::uint32_t birth_edge, std::uint32_t index) {
  classes_.go_to(index);
  birth_ = birth_edge;
  left_ = kReachedAtLeast + kTimesAll * tree_.size() / rank_[birth_edge];
  const EdgeChain chain = shortened(chain_of(birth_edge));
  const EdgeChain wanted = classes_.tunnel_of(birth_edge);
  Loop best{length_of(chain), {}};
  const auto [v, w] = ends(birth_edge);
  look_from(v, wanted, best);
  look_from(w, wanted, best);
  if (best.edges.empty()) return tightened(chain);
  tighten(wanted, {v, w}, best);
  return best.edges;
}

}  // namespace orthoball
