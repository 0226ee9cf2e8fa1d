// SPDX-License-Identifier: MIT
//
// A cell's orthocentre lies beyond a facet exactly where the opposite corner attaches the facet, so
// the exact test is that of attached_faces. Along a flow orthoradii grow, hence no cell in the
// complex is met. The outside is found backwards, from the cells that flow to infinity.
//
// Edelsbrunner, Facello, Liang. On the definition and the construction of pockets in
// macromolecules. Discrete Applied Mathematics 88 (1998).
#include "orthoball/queries/pockets.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "orthoball/exact/attached_faces.h"
#include "orthoball/raw_vector.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

template <int D>
class PocketSearch {
 public:
  PocketSearch(const Filtration<D>& filtration, std::uint32_t index, double alpha2)
      : filtration_(filtration),
        cells_(filtration.triangulation().template cells<D>()),
        free_(filtration, index, alpha2) {}

  std::vector<Pocket> found(Threads threads) {
    find_flow();
    find_outside();
    std::vector<Pocket> pockets = components();
    parallel_for(threads, pockets.size(), [&](std::size_t i) { measure(pockets[i]); });
    return pockets;
  }

 private:
  [[nodiscard]] SimplexId id(std::uint32_t cell) const {
    return SimplexId(filtration_.table().first(D) + cell);
  }
  [[nodiscard]] SimplexId facet(std::uint32_t cell, unsigned corner) const {
    return SimplexId(filtration_.table().first(D - 1) +
                     filtration_.table().template facet_of_cell<D>(cells_, cell, corner));
  }
  [[nodiscard]] bool flows(std::uint32_t cell, unsigned corner) const {
    constexpr unsigned kAll = (2U << D) - 1;
    return (unsigned{attached_[cell]} >> (kAll ^ 1U << corner) & 1U) != 0;
  }
  [[nodiscard]] bool is_of_pocket(std::uint32_t cell) const {
    return !is_outside_[cell] && !free_.is_in(id(cell));
  }

  void find_flow();
  void find_outside();
  std::vector<Pocket> components();
  void measure(Pocket& pocket) const;
  void find_mouths(Pocket& pocket) const;

  const Filtration<D>& filtration_;
  std::span<const CellRecord<D>> cells_;
  FreeSpace<D> free_;
  RawVector<std::uint16_t> attached_;  // [cell]: as attached_faces gives it
  std::vector<bool> is_outside_;       // [cell]
};

template <int D>
void PocketSearch<D>::find_flow() {
  constexpr std::size_t kBlock = 256;
  attached_.resize(cells_.size());
  std::array<CornerSites<std::size_t{D} + 1>, kBlock> corners;
  for (std::size_t first = 0; first < cells_.size(); first += kBlock) {
    const std::size_t size = std::min(kBlock, cells_.size() - first);
    for (std::size_t i = 0; i < size; ++i) corners[i] = cells_[first + i].corners;
    attached_faces<D, std::size_t{D} + 1>(filtration_.triangulation().sites(),
                                          std::span(corners).first(size),
                                          std::span(attached_).subspan(first, size));
  }
}

template <int D>
void PocketSearch<D>::find_outside() {
  is_outside_.assign(cells_.size(), false);
  std::vector<std::uint32_t> reached;
  const auto reach = [&](std::uint32_t cell) {
    if (is_outside_[cell] || free_.is_in(id(cell))) return;
    is_outside_[cell] = true;
    reached.push_back(cell);
  };
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    for (unsigned corner = 0; corner <= D; ++corner) {
      if (cells_[cell].neighbours[corner] == kOutside && flows(cell, corner)) reach(cell);
    }
  }
  while (!reached.empty()) {
    const std::uint32_t cell = reached.back();
    reached.pop_back();
    for (const std::uint32_t beyond : cells_[cell].neighbours) {
      if (beyond != kOutside && flows(beyond / 4, beyond % 4)) reach(beyond / 4);
    }
  }
}

template <int D>
std::vector<Pocket> PocketSearch<D>::components() {
  UnionFind joined(cells_.size());
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    if (!is_of_pocket(cell)) continue;
    for (unsigned corner = 0; corner <= D; ++corner) {
      const std::uint32_t beyond = cells_[cell].neighbours[corner];
      if (beyond == kOutside || beyond / 4 > cell || !is_of_pocket(beyond / 4)) continue;
      if (!free_.is_in(facet(cell, corner))) joined.unite(cell, beyond / 4);
    }
  }
  std::map<std::uint32_t, std::size_t> number_of_root;
  std::vector<Pocket> pockets;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    if (!is_of_pocket(cell)) continue;
    const auto [place, is_new] = number_of_root.try_emplace(joined.find(cell), pockets.size());
    if (is_new) pockets.emplace_back();
    pockets[place->second].cells.push_back(id(cell));
  }
  return pockets;
}

template <int D>
void PocketSearch<D>::measure(Pocket& pocket) const {
  FreePart part = free_.part(pocket.cells);
  pocket.volume = part.volume;
  pocket.area = part.area;
  pocket.lining = std::move(part.lining);
  find_mouths(pocket);
  if (pocket.mouths.empty()) return;
  std::uint32_t last_cell = 0, last_facet = 0;
  for (const SimplexId cell : pocket.cells) {
    last_cell = std::max(last_cell, filtration_.enters(cell));
  }
  for (const Mouth& mouth : pocket.mouths) {
    for (const SimplexId facet : mouth.facets) {
      last_facet = std::max(last_facet, filtration_.enters(facet));
    }
  }
  pocket.depth = filtration_.alpha2(last_cell) - filtration_.alpha2(last_facet);
}

template <int D>
void PocketSearch<D>::find_mouths(Pocket& pocket) const {
  std::vector<SimplexId> facets;
  for (const SimplexId one : pocket.cells) {
    const std::uint32_t cell = one.row() - filtration_.table().first(D);
    for (unsigned corner = 0; corner <= D; ++corner) {
      const std::uint32_t beyond = cells_[cell].neighbours[corner];
      const bool leads_outside = beyond == kOutside || is_outside_[beyond / 4];
      if (leads_outside && !free_.is_in(facet(cell, corner))) {
        facets.push_back(facet(cell, corner));
      }
    }
  }
  std::sort(facets.begin(), facets.end());
  UnionFind joined(facets.size());
  std::map<SimplexId, std::uint32_t> first_at;  // by a face outside the complex
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    for (const SimplexId face : filtration_.facets(facets[i])) {
      if (free_.is_in(face)) continue;
      const auto [place, is_new] = first_at.try_emplace(face, i);
      if (!is_new) joined.unite(place->second, i);
    }
  }
  std::map<std::uint32_t, Mouth> mouths;  // by the first facet
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    Mouth& mouth = mouths[joined.find(i)];
    mouth.area += free_.part_of_facet(facets[i]);
    mouth.facets.push_back(facets[i]);
  }
  for (auto& [first, mouth] : mouths) {
    std::set<SiteId> rim;
    for (const SimplexId facet : mouth.facets) {
      for (const VertexId vertex : filtration_.vertices(facet)) {
        if (free_.is_in(SimplexId(vertex.row()))) {
          rim.insert(filtration_.triangulation().sites().row(vertex.row()));
        }
      }
    }
    mouth.rim.assign(rim.begin(), rim.end());
    pocket.mouths.push_back(std::move(mouth));
  }
  std::stable_sort(pocket.mouths.begin(), pocket.mouths.end(),
                   [](const Mouth& a, const Mouth& b) { return a.area > b.area; });
}

}  // namespace

template <int D>
std::vector<Pocket> pockets(const Filtration<D>& filtration, std::uint32_t index, double alpha2,
                            Threads threads) {
  PocketSearch<D> search(filtration, index, alpha2);
  if (filtration.triangulation().affine_dimension() < D) return {};
  std::vector<Pocket> found = search.found(threads);
  std::stable_sort(found.begin(), found.end(), is_listed_before<Pocket>);
  return found;
}

template std::vector<Pocket> pockets<2>(const Filtration<2>&, std::uint32_t, double, Threads);
template std::vector<Pocket> pockets<3>(const Filtration<3>&, std::uint32_t, double, Threads);

}  // namespace orthoball
