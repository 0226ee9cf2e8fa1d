// SPDX-License-Identifier: MIT
//
// Facets are taken in the order of their numbers, which is that of their owners. Several threads
// take parts of them that begin with a cell's first facet; a cell of another part is told after all
// have ended.
#include "orthoball/topology/facet_roles.h"

#include <algorithm>

namespace orthoball {
namespace {

// What a facet tells the cell on its other side, which belongs to another part.
struct Message {
  std::uint32_t cell;
  std::uint8_t bits;
};

}  // namespace

template <int D>
FacetRoles<D>::FacetRoles(const Filtration<D>& filtration, Threads threads) {
  const auto cells = filtration.triangulation().template cells<D>();
  const SimplexTable<D>& table = filtration.table();
  const std::size_t words = filtration.count(D - 1) / 64 + 1;
  if (cells.empty()) {
    singular_.assign(words + 1, ~std::uint64_t{0});
    return;
  }
  of_cells_.assign(cells.size(), 0);
  singular_.assign(words + 1, 0);
  const std::span<const std::uint32_t> owners = table.facet_owners();
  const std::span<const std::uint32_t> enters = filtration.enters();
  const std::span<const std::uint32_t> of_facets = enters.subspan(table.first(D - 1));
  const std::span<const std::uint32_t> of_cells = enters.subspan(table.first(D));
  constexpr std::uint32_t kNever = 0xFFFFFFFFU;

  // Parts of whole words; cells on the seams belong to the part of their first facet.
  const std::size_t parts = threads.count();
  std::vector<std::vector<Message>> messages(parts);
  parallel_parts(threads, words, parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
    const std::size_t last = std::min(64 * end, owners.size());
    if (64 * begin >= last) return;
    const auto first_cell_of = [&](std::size_t facet) {
      if (facet == 0) return std::uint32_t{0};
      if (facet >= owners.size()) return static_cast<std::uint32_t>(cells.size());
      return owners[facet] / 4 + (owners[facet] / 4 == owners[facet - 1] / 4 ? 1U : 0U);
    };
    const std::uint32_t first_cell = first_cell_of(64 * begin);
    const std::uint32_t end_cell = first_cell_of(last);
    const auto tell = [&](std::uint32_t cell, unsigned bits) {
      if (cell - first_cell < end_cell - first_cell) {
        of_cells_[cell] = static_cast<std::uint8_t>(of_cells_[cell] | bits);
      } else if (bits != 0) {
        messages[part].push_back({cell, static_cast<std::uint8_t>(bits)});
      }
    };
    for (std::size_t word = begin; word < end; ++word) {
      std::uint64_t singular = 0;
      for (std::size_t facet = 64 * word; facet < std::min(64 * word + 64, last); ++facet) {
        const std::uint32_t cell = owners[facet] / 4, corner = owners[facet] % 4;
        const std::uint32_t beyond = cells[cell].neighbours[corner];
        const bool is_hull = beyond == kOutside;
        const std::uint32_t index = of_facets[facet];
        const std::uint32_t own = of_cells[cell];
        const std::uint32_t other = is_hull ? kNever : of_cells[beyond / 4];
        // The owner is the smaller of the two.
        const unsigned other_is_second = own <= other ? 1 : 0;
        const unsigned with_own = index == own ? kEntersWith : 0;
        const unsigned with_other = index == other ? kEntersWith : 0;
        singular |= std::uint64_t{(with_own | with_other) == 0} << facet % 64;
        tell(cell, (with_own | (1 - other_is_second)) << corner);
        if (!is_hull) tell(beyond / 4, (with_other | other_is_second) << beyond % 4);
      }
      singular_[word] = singular;
    }
  });
  for (const auto& of_part : messages) {
    for (const Message& message : of_part) {
      of_cells_[message.cell] = static_cast<std::uint8_t>(of_cells_[message.cell] | message.bits);
    }
  }
}

template class FacetRoles<2>;
template class FacetRoles<3>;

}  // namespace orthoball
