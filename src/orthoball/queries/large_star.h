// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/queries/star_parts.h"

namespace orthoball {

/// The parts of the cells around one vertex (StarParts), kept while cells change sides: for
/// vertices with so many cells that one does not look at all of them whenever one changes.
///
/// A change costs about what it takes and gives to the parts that it makes smaller: where it cuts
/// one, all pieces are flooded in turn until only one is left, and of those that it joins all but
/// the largest are flooded. Four numbers a cell. Refers to the filtration and the stars.
template <int D>
class LargeStar {
 public:
  /// @param stars   of that filtration; read anew.
  /// @param solid   [cell]: whether it is inside.
  LargeStar(const Filtration<D>& filtration, StarParts<D>& stars, std::uint32_t vertex,
            const std::vector<bool>& solid);

  /// As StarParts says it.
  [[nodiscard]] std::uint32_t surplus() const;
  /// The surplus after cells, of one side, change to the other.
  /// @param cells  ascending; those that do not have the vertex do not matter.
  [[nodiscard]] std::uint32_t surplus_after(std::span<const std::uint32_t> cells) const;
  /// They change.
  void turn(std::span<const std::uint32_t> cells);

 private:
  using Place = std::uint32_t;  // in the ascending cells of the star; their number for the outside
  using Places = std::vector<Place>;
  struct Part {
    bool is_inside;
    std::size_t size;
  };
  // What joins a change: changed cells next to each other and the parts beside them.
  struct Group {
    Places places;
    std::unordered_map<std::uint32_t, Place> parts;  // and a place of each
  };
  struct Change {
    Places places;
    bool was_inside = false;
    std::vector<Group> groups;
    std::vector<Places> pieces;           // cut off, one piece of each part less
    std::array<std::int64_t, 2> count{};  // of parts, after it
  };

  template <class Visit>
  void for_each_beside(Place place, const Visit& visit) const {
    for (std::size_t side = 0; side < D; ++side) visit(beside_[D * place + side]);
  }
  [[nodiscard]] Place place_of(std::uint32_t cell) const;
  [[nodiscard]] std::uint32_t part_at(Place place) const;
  [[nodiscard]] Change change(std::span<const std::uint32_t> cells) const;
  void find_groups(Change& change) const;
  void find_pieces(Change& change) const;
  void cut(Change& change, const Places& seeds) const;
  void flood(Place start, std::uint32_t part);

  std::span<const CellRecord<D>> records_;
  std::span<const std::uint32_t> cells_;
  std::uint32_t vertex_;
  Places beside_;             // [D * place + side]: what shares a facet that has the vertex
  Places part_of_;            // [place]
  std::vector<Part> parts_;   // some are empty; the first has the outside, if it comes
  bool has_outside_ = false;  // beyond the convex hull
  std::array<std::int64_t, 2> count_{};  // of parts, outside and inside the solid
};

extern template class LargeStar<2>;  // defined in large_star.cpp
extern template class LargeStar<3>;

}  // namespace orthoball
