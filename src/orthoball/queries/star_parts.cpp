// SPDX-License-Identifier: MIT
#include "orthoball/queries/star_parts.h"

#include <array>
#include <limits>

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace

template <int D>
StarParts<D>::StarParts(const Filtration<D>& filtration)
    : records_(filtration.triangulation().template cells<D>()),
      first_(filtration.count(0) + 1, 0),
      cells_((std::size_t{D} + 1) * records_.size()),
      place_(records_.size()) {
  for (const CellRecord<D>& cell : records_) {
    for (const std::uint32_t vertex : cell.corners) ++first_[vertex + 1];
  }
  for (std::size_t vertex = 1; vertex < first_.size(); ++vertex) {
    first_[vertex] += first_[vertex - 1];
  }
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t cell = 0; cell < records_.size(); ++cell) {
    for (const std::uint32_t vertex : records_[cell].corners) cells_[next[vertex]++] = cell;
  }
}

template <int D>
void StarParts<D>::read(std::uint32_t vertex, const std::vector<bool>& solid) {
  vertex_ = vertex;
  here_ = cells(vertex);
  for (std::uint32_t place = 0; place < here_.size(); ++place) place_[here_[place]] = place;
  parts_.clear();
  part_of_.assign(here_.size(), kNone);
  front_.clear();
  bool is_on_hull = false;
  for (std::size_t place = 0; place < here_.size(); ++place) {
    bool is_at_hull = false;
    for_each_beside(place, [&](std::size_t beside) { is_at_hull |= beside == here_.size(); });
    is_on_hull |= is_at_hull;
    if (is_at_hull && !solid[here_[place]]) front_.push_back(place);
  }
  if (is_on_hull) {
    parts_.push_back({false, true});
    flood(solid);
  }
  for (std::size_t start = 0; start < here_.size(); ++start) {
    if (part_of_[start] != kNone) continue;
    parts_.push_back({solid[here_[start]], false});
    front_.push_back(start);
    flood(solid);
  }
}

// Gives the last part what can be reached from the places in front_.
template <int D>
void StarParts<D>::flood(const std::vector<bool>& solid) {
  const auto part = static_cast<std::uint32_t>(parts_.size() - 1);
  for (const std::size_t place : front_) part_of_[place] = part;
  while (!front_.empty()) {
    const std::size_t place = front_.back();
    front_.pop_back();
    for_each_beside(place, [&](std::size_t beside) {
      if (beside == here_.size() || part_of_[beside] != kNone) return;
      if (solid[here_[beside]] != parts_[part].is_inside) return;
      part_of_[beside] = part;
      front_.push_back(beside);
    });
  }
}

template <int D>
std::uint32_t StarParts<D>::surplus() const {
  std::array<std::uint32_t, 2> count{};
  for (const StarPart& part : parts_) ++count[part.is_inside ? 1 : 0];
  std::uint32_t surplus = 0;
  for (const std::uint32_t of_side : count) surplus += of_side > 1 ? of_side - 1 : 0;
  return surplus;
}

template class StarParts<2>;
template class StarParts<3>;

}  // namespace orthoball
