// SPDX-License-Identifier: MIT
//
// The column of a triangle is its boundary, which is reduced by the columns of earlier triangles
// until its last edge is the last of no other. Where a triangle is the first coface of its last
// edge nothing is to be done (apparent pairs), and its column need not be stored: most are of this
// kind.
//
// Edelsbrunner, Letscher, Zomorodian. Topological persistence and simplification. Discrete &
// Computational Geometry 28 (2002).
// Bauer. Ripser: efficient computation of Vietoris-Rips persistence barcodes. Journal of Applied
// and Computational Topology 5 (2021), for apparent pairs.
#include "orthoball/topology/tunnel_reduction.h"

#include <algorithm>

#include "orthoball/filtration/edge_ring.h"

namespace orthoball {
namespace {

// A column of edges while it is reduced: a heap of keys, in which an edge that is there twice is
// not there.
class Column {
 public:
  void clear() { keys_.clear(); }
  void add(std::uint64_t key) {
    keys_.push_back(key);
    std::push_heap(keys_.begin(), keys_.end());
  }
  // Takes the last edge out; false if there is none.
  bool take_last(std::uint64_t& key) {
    while (!keys_.empty()) {
      key = take();
      if (keys_.empty() || keys_.front() != key) return true;
      (void)take();
    }
    return false;
  }

 private:
  std::uint64_t take() {
    std::pop_heap(keys_.begin(), keys_.end());
    const std::uint64_t key = keys_.back();
    keys_.pop_back();
    return key;
  }

  std::vector<std::uint64_t> keys_;
};

}  // namespace

TriangleBoundaries::TriangleBoundaries(const Filtration<3>& filtration)
    : owners_(filtration.table().facet_owners()),
      edges_of_cells_(filtration.triangulation().cell_count()) {
  const auto cells = filtration.triangulation().cells<3>();
  const auto edge_owners = filtration.table().edge_owners();
  for (std::uint32_t edge = 0; edge < edge_owners.size(); ++edge) {
    const std::uint32_t owner = edge_owners[edge];
    for_each_around_edge(cells, owner / 6, owner % 6, [&](std::uint32_t cell, unsigned slot) {
      edges_of_cells_[cell][slot] = edge;
    });
  }
}

TunnelReduction::TunnelReduction(const Filtration<3>& filtration, const std::vector<bool>& joins,
                                 const std::vector<bool>& cuts)
    : edges_(filtration, 1),
      triangles_of_(filtration, 2),
      boundaries_(filtration),
      joins_(joins),
      filling_(edges_.count()) {
  std::vector<std::uint64_t> others = find_apparent(cuts);
  std::sort(others.begin(), others.end());
  Column column;
  for (const std::uint64_t key : others) {
    const auto add_boundary = [&](std::uint32_t triangle, std::uint32_t without) {
      for (const std::uint32_t edge : boundaries_.edges(triangle)) {
        if (edge != without && !joins_[edge]) column.add(edges_.key(edge));
      }
    };
    const auto triangle = static_cast<std::uint32_t>(key);
    column.clear();
    add_boundary(triangle, kNone);
    std::uint64_t last = 0;
    while (column.take_last(last)) {
      const auto edge = static_cast<std::uint32_t>(last);
      const std::uint32_t filling = filling_[edge];
      if (filling == kNone) break;
      if (filling < kStored) {
        add_boundary(filling, edge);
      } else {
        const std::size_t number = filling - kStored;
        for (std::size_t i = begins_[number]; i < begins_[number + 1]; ++i) column.add(stored_[i]);
      }
    }
    filling_[static_cast<std::uint32_t>(last)] =
        kStored + static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(triangle);
    while (column.take_last(last)) stored_.push_back(last);
    begins_.push_back(stored_.size());
  }
}

// Fills in the edges whose first triangle has them as its last edge; the keys of the triangles that
// are to be reduced.
std::vector<std::uint64_t> TunnelReduction::find_apparent(const std::vector<bool>& cuts) {
  std::fill(filling_.begin(), filling_.end(), kNone);
  for (std::uint32_t t = 0; t < triangles_of_.count(); ++t) {
    for (const std::uint32_t edge : boundaries_.edges(t)) {
      std::uint32_t& first = filling_[edge];
      if (first == kNone || triangles_of_.enters(t) < triangles_of_.enters(first)) first = t;
    }
  }
  std::vector<std::uint64_t> others;
  std::vector<bool> is_apparent(edges_.count());
  for (std::uint32_t t = 0; t < triangles_of_.count(); ++t) {
    if (cuts[t]) continue;
    const auto [a, b, c] = boundaries_.edges(t);
    const std::uint64_t key = std::max({edges_.key(a), edges_.key(b), edges_.key(c)});
    const auto last = static_cast<std::uint32_t>(key);
    if (filling_[last] == t) {
      is_apparent[last] = true;
    } else {
      others.push_back(triangles_of_.key(t));
    }
  }
  for (std::uint32_t edge = 0; edge < edges_.count(); ++edge) {
    if (!is_apparent[edge]) filling_[edge] = kNone;
  }
  return others;
}

}  // namespace orthoball
