// SPDX-License-Identifier: MIT
#include "orthoball/queries/star_pieces.h"

#include <algorithm>
#include <limits>

namespace orthoball {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

}  // namespace

template <int D>
void StarPieces<D>::take_out(std::span<const std::uint32_t> cells) {
  if (last_mark_ > std::numeric_limits<std::uint32_t>::max() / 2) {
    std::fill(mark_.begin(), mark_.end(), 0U);
    last_mark_ = 0;
  }
  out_mark_ = ++last_mark_;
  for (const std::uint32_t cell : cells) mark_[cell] = out_mark_;
}

template <int D>
std::size_t StarPieces<D>::root(std::size_t flood) {
  while (floods_[flood].joined != flood) {
    floods_[flood].joined = floods_[floods_[flood].joined].joined;
    flood = floods_[flood].joined;
  }
  return flood;
}

// A flood comes to a cell: it is new, or has another flood, which is joined.
template <int D>
void StarPieces<D>::come(std::size_t flood, std::uint32_t cell) {
  std::size_t other = kNone;
  if (cell == kOutside) {
    if (outside_flood_ == kNone) outside_flood_ = flood;
    other = outside_flood_;
  } else if (mark_[cell] >= first_mark_) {
    other = mark_[cell] - first_mark_;
  } else {
    ++work_;
    mark_[cell] = first_mark_ + static_cast<std::uint32_t>(flood);
    floods_[flood].cells.push_back(cell);
    return;
  }
  const std::size_t here = root(flood), there = root(other);
  if (here == there) return;
  floods_[there].joined = here;
  floods_[here].open += floods_[there].open;
  --left_;
}

// A flood cannot go on. If none that is joined to it can, they are a piece, unless they have what
// is beyond the hull: that is never done, and what comes there is one with it.
template <int D>
void StarPieces<D>::end(std::size_t flood) {
  const std::size_t all = root(flood);
  if (--floods_[all].open > 0) return;
  if (outside_flood_ != kNone && root(outside_flood_) == all) return;
  floods_[all].is_done = true;
  --left_;
}

// One cell further; false if it cannot.
template <int D>
bool StarPieces<D>::go_on(std::size_t flood, std::uint32_t vertex, const std::vector<bool>& solid) {
  Flood& one = floods_[flood];
  if (one.next == one.cells.size()) {
    end(flood);
    return false;
  }
  const std::uint32_t cell = one.cells[one.next++];
  const bool side = solid[cell];
  for_each_beside(records_, vertex, cell, [&](std::uint32_t beside) {
    if (is_out(beside) || (beside != kOutside && solid[beside]) != side) return;
    come(flood, beside);
  });
  return true;
}

template <int D>
std::size_t StarPieces<D>::count(std::uint32_t vertex, const std::vector<bool>& solid,
                                 std::span<const std::uint32_t> seeds) {
  flood_count_ = seeds.size();
  if (floods_.size() < flood_count_) floods_.resize(flood_count_);
  first_mark_ = last_mark_ + 1;
  last_mark_ += static_cast<std::uint32_t>(flood_count_);
  left_ = flood_count_;
  outside_flood_ = kNone;
  going_.clear();
  for (std::size_t flood = 0; flood < flood_count_; ++flood) {
    Flood& one = floods_[flood];
    going_.push_back(flood);
    one.cells.clear();
    one.next = 0;
    one.joined = flood;
    one.open = 1;
    one.is_done = false;
  }
  for (std::size_t flood = 0; flood < flood_count_; ++flood) come(flood, seeds[flood]);
  while (left_ > 1) {
    std::erase_if(going_,
                  [&](std::size_t flood) { return left_ > 1 && !go_on(flood, vertex, solid); });
  }
  std::size_t pieces = left_;
  for (std::size_t flood = 0; flood < flood_count_; ++flood) pieces += floods_[flood].is_done;
  return pieces;
}

template <int D>
std::vector<std::vector<std::uint32_t>> StarPieces<D>::cut_off() {
  std::vector<std::vector<std::uint32_t>> pieces;
  std::vector<std::size_t> piece_of(flood_count_, kNone);
  for (std::size_t flood = 0; flood < flood_count_; ++flood) {
    const std::size_t all = root(flood);
    if (!floods_[all].is_done) continue;
    if (piece_of[all] == kNone) {
      piece_of[all] = pieces.size();
      pieces.emplace_back();
    }
    auto& piece = pieces[piece_of[all]];
    piece.insert(piece.end(), floods_[flood].cells.begin(), floods_[flood].cells.end());
  }
  return pieces;
}

template class StarPieces<2>;
template class StarPieces<3>;

}  // namespace orthoball
