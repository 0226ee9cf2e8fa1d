// SPDX-License-Identifier: MIT
//
// A range of positions is cut at its median along the axis in which it is longest: the median
// stands in the middle of the range, the lower half before it, the upper half behind, and so on in
// the halves down to a few positions. So the tree is the order of the array; only the axis of each
// cut is kept.
//
// The nearest to q are looked for in the half that holds q first. The other half is left out if its
// distance to q along the cut alone is not below the largest of the k least squares found so far.
// All squares are rounded, but rounding never turns an order round: no sum over all axes is less
// than the rounded square along one of them. So what is found is right for the rounded squares.
//
// Bentley. Multidimensional binary search trees used for associative searching. Communications of
// the ACM 18 (1975).
#include "orthoball/points/position_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace orthoball {
namespace {

constexpr std::size_t kFew = 8;  // positions that are compared one by one

template <int D>
using PositionOf = std::array<double, std::size_t{D}>;

template <int D>
struct Placed {
  PositionOf<D> x;
  std::uint32_t number;  // among the distinct positions in lexicographic order
};

// One of each; the number of each row's is written.
template <int D>
std::vector<Placed<D>> distinct_positions(const WeightedPoints& points,
                                          std::vector<std::uint32_t>& number_of_row) {
  const auto coordinates = points.coordinates();
  const auto position = [&](std::size_t row) {
    PositionOf<D> x;
    for (std::size_t axis = 0; axis < D; ++axis) x[axis] = coordinates[D * row + axis];
    return x;
  };
  std::vector<std::pair<PositionOf<D>, std::uint32_t>> rows(points.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    rows[row] = {position(row), static_cast<std::uint32_t>(row)};
  }
  std::sort(rows.begin(), rows.end());
  std::vector<Placed<D>> distinct;
  number_of_row.resize(rows.size());
  for (const auto& [x, row] : rows) {
    if (distinct.empty() || distinct.back().x != x) {
      distinct.push_back({x, static_cast<std::uint32_t>(distinct.size())});
    }
    number_of_row[row] = distinct.back().number;
  }
  return distinct;
}

template <int D>
std::uint8_t longest_axis(std::span<const Placed<D>> range) {
  PositionOf<D> low = range[0].x, high = range[0].x;
  for (const Placed<D>& placed : range) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      low[axis] = std::min(low[axis], placed.x[axis]);
      high[axis] = std::max(high[axis], placed.x[axis]);
    }
  }
  std::uint8_t longest = 0;
  for (std::uint8_t axis = 1; axis < D; ++axis) {
    if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
  }
  return longest;
}

// Cuts a range in its middle.
template <int D>
void cut(std::span<Placed<D>> range, std::span<std::uint8_t> axes) {
  const std::size_t middle = range.size() / 2;
  const std::uint8_t axis = longest_axis<D>(range);
  std::nth_element(range.begin(), range.begin() + static_cast<std::ptrdiff_t>(middle), range.end(),
                   [axis](const Placed<D>& a, const Placed<D>& b) {
                     return std::pair(a.x[axis], a.number) < std::pair(b.x[axis], b.number);
                   });
  axes[middle] = axis;
}

// And in its halves, down to a few positions.
template <int D>
void arrange(std::span<Placed<D>> range, std::span<std::uint8_t> axes) {
  if (range.size() <= kFew) return;
  cut(range, axes);
  const std::size_t middle = range.size() / 2;
  arrange(range.first(middle), axes.first(middle));
  arrange(range.subspan(middle + 1), axes.subspan(middle + 1));
}

// The same on several threads: the first cuts one after the other, then all ranges at once.
template <int D>
void arrange_all(std::span<Placed<D>> all, std::span<std::uint8_t> axes, Threads threads) {
  constexpr std::size_t kLeast = std::size_t{1} << 14U;  // positions that are worth a task
  const std::size_t wanted = threads.count() == 1 ? 1 : std::size_t{8} * threads.count();
  std::vector<std::pair<std::size_t, std::size_t>> ranges{{0, all.size()}};
  while (ranges.size() < wanted && ranges[0].second - ranges[0].first > kLeast) {
    std::vector<std::pair<std::size_t, std::size_t>> halves(2 * ranges.size());
    parallel_for(threads, ranges.size(), [&](std::size_t i) {
      const auto [begin, end] = ranges[i];
      const std::size_t middle = begin + (end - begin) / 2;
      cut(all.subspan(begin, end - begin), axes.subspan(begin, end - begin));
      halves[2 * i] = {begin, middle};
      halves[2 * i + 1] = {middle + 1, end};
    });
    ranges = std::move(halves);
  }
  parallel_for(threads, ranges.size(), [&](std::size_t i) {
    const auto [begin, end] = ranges[i];
    arrange(all.subspan(begin, end - begin), axes.subspan(begin, end - begin));
  });
}

// The search for the nearest to one position.
template <int D>
class Search {
 public:
  Search(std::span<const PositionOf<D>> positions, std::span<const std::uint8_t> axes,
         std::uint32_t of, std::span<double> squares)
      : positions_(positions), axes_(axes), of_(of), squares_(squares) {}

  void run() {
    look(0, positions_.size());
    std::sort_heap(squares_.begin(), squares_.end());
  }

 private:
  void look(std::size_t begin, std::size_t end) {
    if (end - begin <= kFew) {
      for (std::size_t at = begin; at < end; ++at) take(at);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const std::uint8_t axis = axes_[middle];
    const double beyond = positions_[of_][axis] - positions_[middle][axis];
    const bool is_low = beyond < 0.0 || (beyond == 0.0 && of_ < middle);
    is_low ? look(begin, middle) : look(middle + 1, end);
    take(middle);
    if (found_ == squares_.size() && beyond * beyond >= squares_[0]) return;
    is_low ? look(middle + 1, end) : look(begin, middle);
  }

  void take(std::size_t at) {
    if (at == of_) return;
    double square = 0.0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double along = positions_[at][axis] - positions_[of_][axis];
      square += along * along;
    }
    const auto heap_end = squares_.begin() + static_cast<std::ptrdiff_t>(found_);
    if (found_ < squares_.size()) {
      *heap_end = square;
      ++found_;
      std::push_heap(squares_.begin(), heap_end + 1);
    } else if (square < squares_[0]) {
      std::pop_heap(squares_.begin(), squares_.end());
      squares_.back() = square;
      std::push_heap(squares_.begin(), squares_.end());
    }
  }

  std::span<const PositionOf<D>> positions_;
  std::span<const std::uint8_t> axes_;
  std::uint32_t of_;
  std::span<double> squares_;  // a heap of the least so far, the largest first
  std::size_t found_ = 0;
};

}  // namespace

template <int D>
PositionTree<D>::PositionTree(const WeightedPoints& points, Threads threads) {
  std::vector<std::uint32_t> number_of_row;
  std::vector<Placed<D>> placed = distinct_positions<D>(points, number_of_row);
  axes_.resize(placed.size());
  arrange_all<D>(placed, axes_, threads);
  positions_.resize(placed.size());
  std::vector<std::uint32_t> position_of_number(placed.size());
  for (std::size_t at = 0; at < placed.size(); ++at) {
    positions_[at] = placed[at].x;
    position_of_number[placed[at].number] = static_cast<std::uint32_t>(at);
  }
  position_of_row_ = std::move(number_of_row);
  for (std::uint32_t& of_row : position_of_row_) of_row = position_of_number[of_row];
}

template <int D>
void PositionTree<D>::nearest_squares(std::uint32_t position, std::span<double> squares) const {
  if (!squares.empty()) Search<D>(positions_, axes_, position, squares).run();
}

template class PositionTree<2>;
template class PositionTree<3>;

}  // namespace orthoball
