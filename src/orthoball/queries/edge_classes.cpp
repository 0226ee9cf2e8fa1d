// SPDX-License-Identifier: MIT
//
// An edge that joins components has no part in any class. One whose tunnel lives stands for itself.
// One whose loop is filled has the parts of the other edges of its chain, all of which come before
// it. A part remains as it is until the tunnel of one of its edges dies; then these edges' parts
// take their place.
//
// The tunnel of an edge is the class of its chain, in which the edge itself comes last. A class is
// a sum of certain tunnels if taking its last edge's tunnel away, time and again, leaves nothing
// and takes no others.
//
// Busaryev, Cabello, Chen, Dey, Wang. Annotating simplices with a homology basis and its
// applications. SWAT 2012.
#include "orthoball/queries/edge_classes.h"

#include <algorithm>

namespace orthoball {
namespace {

constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

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

EdgeClasses::EdgeClasses(const Filtration<3>& filtration, const PersistencePairs<3>& all)
    : edges_(filtration, 1),
      triangles_(filtration, 2),
      joins_(marked(edges_.count(), edges_, all[0], false)),
      cuts_(marked(triangles_.count(), triangles_, all[2], true)),
      reduction_(filtration, joins_, cuts_),
      parts_(edges_.count()) {}

// Of the tunnel of an edge.
std::uint32_t EdgeClasses::death(std::uint32_t edge) const {
  return triangles_.enters(reduction_.filled_by(edge));
}

bool EdgeClasses::lives(std::uint32_t edge) const { return !joins_[edge] && death(edge) > index_; }

// Whether what was known of an edge whose loop is filled, held at an earlier index.
bool EdgeClasses::held(std::uint32_t edge) const {
  return parts_[edge].from <= index_ && parts_[edge].from >= death(edge);
}

// Calls `visit(other)` for edges of which the part of one whose loop is filled is the sum.
template <class Visit>
void EdgeClasses::for_each_source(std::uint32_t edge, const Visit& visit) const {
  if (held(edge)) {
    for (const std::uint32_t other : parts_[edge].chain) visit(other);
  } else {
    reduction_.for_each_before(edge, visit);
  }
}

// Where the sources' parts hold.
void EdgeClasses::find_part(std::uint32_t edge) {
  Known& known = parts_[edge];
  if (joins_[edge]) {
    known = {0, kNever, {}};
  } else if (lives(edge)) {
    known = {edges_.enters(edge), death(edge), {edge}};
  } else {
    std::uint32_t from = held(edge) ? known.from : death(edge), until = kNever;
    EdgeChain part;
    for_each_source(edge, [&](std::uint32_t other) {
      part = sum(part, parts_[other].chain);
      from = std::max(from, parts_[other].from);
    });
    for (const std::uint32_t other : part) until = std::min(until, death(other));
    known = {from, until, std::move(part)};
  }
}

const EdgeChain& EdgeClasses::part_of(std::uint32_t edge) {
  if (holds(parts_[edge])) return parts_[edge].chain;
  std::vector<std::uint32_t> open{edge};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    const std::size_t known = open.size();
    if (!holds(parts_[at]) && !joins_[at] && !lives(at)) {
      for_each_source(at, [&](std::uint32_t other) {
        if (!holds(parts_[other])) open.push_back(other);
      });
    }
    if (open.size() > known) continue;
    if (!holds(parts_[at])) find_part(at);
    open.pop_back();
  }
  return parts_[edge].chain;
}

const EdgeChain& EdgeClasses::tunnel_of(std::uint32_t edge) {
  Known& known = tunnels_[edge];
  if (holds(known)) return known.chain;
  EdgeChain tunnel = part_of(edge);
  std::uint32_t from = parts_[edge].from, until = death(edge);
  const auto add = [&](std::uint32_t other) {
    tunnel = sum(tunnel, part_of(other));
    from = std::max(from, parts_[other].from);
  };
  reduction_.for_each_before(edge, add);
  for (const std::uint32_t other : tunnel) until = std::min(until, death(other));
  known = {from, until, std::move(tunnel)};
  return known.chain;
}

std::uint32_t EdgeClasses::last_of(const EdgeChain& chain) const {
  return *std::max_element(chain.begin(), chain.end(), [&](std::uint32_t a, std::uint32_t b) {
    return edges_.key(a) < edges_.key(b);
  });
}

bool EdgeClasses::is_free(std::uint32_t edge, std::uint32_t other) const {
  return edges_.key(edge) < edges_.key(other) &&
         triangles_.key(reduction_.filled_by(edge)) < triangles_.key(reduction_.filled_by(other));
}

bool EdgeClasses::is_free_class(EdgeChain of_class, std::uint32_t other) {
  while (!of_class.empty()) {
    const std::uint32_t last = last_of(of_class);
    if (!is_free(last, other)) return false;
    of_class = sum(of_class, tunnel_of(last));
  }
  return true;
}

}  // namespace orthoball
