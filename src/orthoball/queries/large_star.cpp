// SPDX-License-Identifier: MIT
#include "orthoball/queries/large_star.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

std::uint32_t surplus_of(const std::array<std::int64_t, 2>& count) {
  std::int64_t surplus = 0;
  for (const std::int64_t of_side : count) surplus += of_side > 1 ? of_side - 1 : 0;
  return static_cast<std::uint32_t>(surplus);
}

}  // namespace

template <int D>
LargeStar<D>::LargeStar(const Filtration<D>& filtration, StarParts<D>& stars, std::uint32_t vertex,
                        const std::vector<bool>& solid)
    : records_(filtration.triangulation().template cells<D>()),
      cells_(stars.cells(vertex)),
      vertex_(vertex) {
  stars.read(vertex, solid);
  part_of_.assign(stars.part_of().begin(), stars.part_of().end());
  for (const StarPart& part : stars.parts()) {
    parts_.push_back({part.is_inside, 0});
    has_outside_ |= part.has_outside;
    ++count_[part.is_inside ? 1 : 0];
  }
  for (const std::uint32_t part : part_of_) ++parts_[part].size;
  for (std::size_t place = 0; place < cells_.size(); ++place) {
    stars.for_each_beside(
        place, [&](std::size_t beside) { beside_.push_back(static_cast<Place>(beside)); });
  }
}

template <int D>
std::uint32_t LargeStar<D>::surplus() const {
  return surplus_of(count_);
}

template <int D>
std::uint32_t LargeStar<D>::surplus_after(std::span<const std::uint32_t> cells) const {
  return surplus_of(change(cells).count);
}

template <int D>
typename LargeStar<D>::Place LargeStar<D>::place_of(std::uint32_t cell) const {
  const auto found = std::lower_bound(cells_.begin(), cells_.end(), cell);
  return static_cast<Place>(found - cells_.begin());
}

template <int D>
std::uint32_t LargeStar<D>::part_at(Place place) const {
  return place == cells_.size() ? 0U : part_of_[place];
}

template <int D>
typename LargeStar<D>::Change LargeStar<D>::change(std::span<const std::uint32_t> cells) const {
  Change result;
  result.count = count_;
  for (const std::uint32_t cell : cells) {
    const auto& corners = records_[cell].corners;
    if (std::find(corners.begin(), corners.end(), vertex_) == corners.end()) continue;
    result.places.push_back(place_of(cell));
  }
  if (result.places.empty()) return result;
  result.was_inside = parts_[part_of_[result.places[0]]].is_inside;
  find_groups(result);
  find_pieces(result);
  return result;
}

template <int D>
void LargeStar<D>::find_groups(Change& change) const {
  const Places& places = change.places;
  const auto number = [&](Place place) {
    const auto found = std::lower_bound(places.begin(), places.end(), place);
    return found != places.end() && *found == place ? found - places.begin() : -1;
  };
  // The changed cells, then the parts beside them.
  std::vector<std::pair<std::uint32_t, Place>> parts;
  std::unordered_map<std::uint32_t, std::uint32_t> node_of_part;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    for_each_beside(places[i], [&](Place beside) {
      const std::uint32_t part = part_at(beside);
      if (const auto other = number(beside); other >= 0) {
        joined.emplace_back(i, static_cast<std::uint32_t>(other));
      } else if (parts_[part].is_inside != change.was_inside) {
        const auto node = static_cast<std::uint32_t>(places.size() + parts.size());
        const auto [found, is_new] = node_of_part.emplace(part, node);
        if (is_new) parts.emplace_back(part, beside);
        joined.emplace_back(i, found->second);
      }
    });
  }
  UnionFind nodes(places.size() + parts.size());
  for (const auto& [a, b] : joined) nodes.unite(a, b);
  std::unordered_map<std::uint32_t, std::size_t> group_of;
  for (std::uint32_t node = 0; node < places.size() + parts.size(); ++node) {
    const auto [found, is_new] = group_of.emplace(nodes.find(node), change.groups.size());
    if (is_new) change.groups.emplace_back();
    Group& group = change.groups[found->second];
    if (node < places.size()) {
      group.places.push_back(places[node]);
    } else {
      group.parts.insert(parts[node - places.size()]);
    }
  }
  change.count[change.was_inside ? 0 : 1] +=
      static_cast<std::int64_t>(change.groups.size()) - static_cast<std::int64_t>(parts.size());
}

template <int D>
void LargeStar<D>::find_pieces(Change& change) const {
  const Places& places = change.places;
  std::vector<std::pair<std::uint32_t, Place>> seeds;  // a part, and a place of it that remains
  std::vector<std::uint32_t> parts;
  for (const Place place : places) {
    parts.push_back(part_of_[place]);
    for_each_beside(place, [&](Place beside) {
      const std::uint32_t part = part_at(beside);
      if (parts_[part].is_inside == change.was_inside &&
          !std::binary_search(places.begin(), places.end(), beside)) {
        seeds.emplace_back(part, beside);
      }
    });
  }
  std::sort(seeds.begin(), seeds.end());
  seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  std::int64_t& count = change.count[change.was_inside ? 1 : 0];
  count -= static_cast<std::int64_t>(parts.size());
  for (std::size_t first = 0, end = 0; first < seeds.size(); first = end) {
    Places of_part;
    while (end < seeds.size() && seeds[end].first == seeds[first].first) {
      of_part.push_back(seeds[end++].second);
    }
    const std::size_t before = change.pieces.size();
    cut(change, of_part);
    count += 1 + static_cast<std::int64_t>(change.pieces.size() - before);
  }
}

// Floods what remains of a part from all seeds in turn until one flood is left, or all others are
// done: these are pieces. The flood that has the outside is never done.
template <int D>
void LargeStar<D>::cut(Change& change, const Places& seeds) const {
  struct Flood {
    Places places;
    std::size_t next = 0;
    bool has_outside = false;
  };
  std::vector<Flood> floods(seeds.size());
  UnionFind joined(seeds.size());
  std::unordered_map<Place, std::uint32_t> flood_at;
  std::size_t left = seeds.size();
  const auto come = [&](std::uint32_t flood, Place place) {
    const auto [found, is_new] = flood_at.emplace(place, flood);
    const std::uint32_t here = joined.find(flood);
    if (is_new) {
      if (place == cells_.size()) {
        floods[here].has_outside = true;
      } else {
        floods[here].places.push_back(place);
      }
      return;
    }
    const std::uint32_t there = joined.find(found->second);
    if (here == there) return;
    joined.unite(here, there);
    const std::uint32_t kept = joined.find(here), gone = kept == here ? there : here;
    Flood &into = floods[kept], &from = floods[gone];
    // Those that are still to be gone from stay behind.
    Places open(into.places.begin() + static_cast<std::ptrdiff_t>(into.next), into.places.end());
    open.insert(open.end(), from.places.begin() + static_cast<std::ptrdiff_t>(from.next),
                from.places.end());
    into.places.resize(into.next);
    into.places.insert(into.places.end(), from.places.begin(),
                       from.places.begin() + static_cast<std::ptrdiff_t>(from.next));
    into.next = into.places.size();
    into.places.insert(into.places.end(), open.begin(), open.end());
    into.has_outside |= from.has_outside;
    from = {};
    --left;
  };
  for (std::uint32_t flood = 0; flood < seeds.size(); ++flood) come(flood, seeds[flood]);
  std::vector<bool> is_done(seeds.size(), false);
  while (left > 1) {
    for (std::uint32_t flood = 0; flood < floods.size() && left > 1; ++flood) {
      if (joined.find(flood) != flood || is_done[flood]) continue;
      Flood& here = floods[flood];
      if (here.next == here.places.size()) {
        if (here.has_outside) continue;
        change.pieces.push_back(here.places);
        is_done[flood] = true;
        --left;
        continue;
      }
      const Place place = here.places[here.next++];
      for_each_beside(place, [&](Place beside) {
        if (parts_[part_at(beside)].is_inside != change.was_inside) return;
        if (std::binary_search(change.places.begin(), change.places.end(), beside)) return;
        come(flood, beside);
      });
    }
  }
}

// Gives a part's cells to another.
template <int D>
void LargeStar<D>::flood(Place start, std::uint32_t part) {
  const std::uint32_t old = part_of_[start];
  Places front{start};
  part_of_[start] = part;
  while (!front.empty()) {
    const Place place = front.back();
    front.pop_back();
    for_each_beside(place, [&](Place beside) {
      if (beside == cells_.size() || part_of_[beside] != old) return;
      part_of_[beside] = part;
      front.push_back(beside);
    });
  }
}

template <int D>
void LargeStar<D>::turn(std::span<const std::uint32_t> cells) {
  const Change change = this->change(cells);
  for (const Places& piece : change.pieces) {
    parts_[part_of_[piece[0]]].size -= piece.size();
    for (const Place place : piece) part_of_[place] = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back({change.was_inside, piece.size()});
  }
  for (const Place place : change.places) --parts_[part_of_[place]].size;
  for (const Group& group : change.groups) {
    // All become the largest part, or that which has the outside.
    auto target = static_cast<std::uint32_t>(parts_.size());
    std::pair<bool, std::size_t> largest{false, 0};
    for (const auto& [part, place] : group.parts) {
      const std::pair size{has_outside_ && part == 0, parts_[part].size};
      if (target < parts_.size() && (size < largest || (size == largest && part > target)))
        continue;
      target = part;
      largest = size;
    }
    if (target == parts_.size()) parts_.push_back({!change.was_inside, 0});
    for (const auto& [part, place] : group.parts) {
      if (part == target) continue;
      parts_[target].size += parts_[part].size;
      parts_[part].size = 0;
      flood(place, target);
    }
    for (const Place place : group.places) part_of_[place] = target;
    parts_[target].size += group.places.size();
  }
  count_ = change.count;
}

template class LargeStar<2>;
template class LargeStar<3>;

}  // namespace orthoball
