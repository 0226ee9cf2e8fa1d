// SPDX-License-Identifier: MIT
//
// Simplices are dealt to stretches of indices in the order of their numbers, in which neighbours in
// space, whose rows are found together, follow each other. Then each stretch, which fits the second
// cache, is sorted by counting, and what is tied in it by rows. So everything goes along memory but
// for what is in the cache.
#include "orthoball/filtration/filter_columns.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/simplex_reader.h"
#include "orthoball/places_of_parts.h"

namespace orthoball {
namespace {

constexpr unsigned kMostStretchBits = 15;  // of the indices of a stretch
constexpr unsigned kStretchCountBits = 6;  // so many stretches, at least, for threads to share
constexpr std::size_t kLeastPart = std::size_t{1} << 14U;  // simplices for a thread of its own

// Calls `visit(begin, end)` for parts of 0..size - 1, on as many threads as are worth it.
template <class Visit>
void for_parts(std::size_t size, Threads threads, const Visit& visit) {
  const Threads used = threads.for_work(size, kLeastPart);
  parallel_parts(used, size, used.count(),
                 [&](std::size_t, std::size_t begin, std::size_t end) { visit(begin, end); });
}

unsigned stretch_bits(std::uint32_t last_index) {
  const auto bits = static_cast<unsigned>(std::bit_width(last_index));
  return std::min(kMostStretchBits, bits > kStretchCountBits ? bits - kStretchCountBits : 0);
}

template <int D>
using Rows = std::array<SiteId, std::size_t{D} + 1>;

// The rows of a simplex of dimension K by its number among these: ascending, filled up with none.
template <int K, int D, int A>
Rows<D> rows_of(const SimplexReader<D, A>& reader, const Sites<D>& sites, std::uint32_t number) {
  const auto corners = reader.template corners<K>(number);
  Rows<D> rows;
  for (std::size_t i = 0; i <= K; ++i) rows[i] = sites.row(corners[i]);
  const auto order = [&](std::size_t i, std::size_t j) {
    const SiteId low = std::min(rows[i], rows[j]);
    rows[j] = std::max(rows[i], rows[j]);
    rows[i] = low;
  };
  if constexpr (K == 3) {
    order(0, 1);
    order(2, 3);
    order(0, 2);
    order(1, 3);
    order(1, 2);
  } else {
    for (std::size_t i = 1; i <= K; ++i) {
      for (std::size_t j = i; j > 0; --j) order(j - 1, j);
    }
  }
  return rows;
}

// What the columns are written to, all as long.
template <int D>
struct Columns {
  std::span<SimplexId> simplices;
  std::span<std::uint8_t> dimensions;
  std::span<Rows<D>> rows;
  std::span<std::uint32_t> enters;
};

template <int D>
class ColumnOrder {
 public:
  // Counts what each stretch gets.
  ColumnOrder(const Filtration<D>& filtration, std::uint32_t last_index, Threads threads)
      : filtration_(filtration),
        last_index_(last_index),
        bits_(stretch_bits(last_index)),
        threads_(threads.for_work(filtration.size(), kLeastPart)),
        begins_((last_index >> bits_) + 2, 0),
        next_(threads_.count()) {
    const std::span<const std::uint32_t> enters = filtration.enters();
    parallel_parts(threads_, enters.size(), next_.size(),
                   [&](std::size_t part, std::size_t begin, std::size_t end) {
                     std::vector<std::uint32_t> counts(stretch_count(), 0);
                     for (std::size_t i = begin; i < end; ++i) {
                       if (enters[i] <= last_index) ++counts[enters[i] >> bits_];
                     }
                     next_[part] = std::move(counts);
                   });
    find_places_of_parts(next_, begins_);
  }

  [[nodiscard]] std::size_t size() const { return begins_.back(); }

  void fill(const Columns<D>& columns) {
    deal(columns);
    parallel_parts(threads_, stretch_count(), threads_.count(),
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     RawVector<Entry> sorted;
                     for (std::size_t i = begin; i < end; ++i) sort(i, columns, sorted);
                   });
  }

 private:
  struct Entry {
    Rows<D> rows;
    SimplexId simplex;
    std::uint32_t enters;
  };

  [[nodiscard]] std::size_t stretch_count() const { return begins_.size() - 1; }

  // Of the triangulation; a single vertex is none.
  template <int A>
  [[nodiscard]] auto cells_of() const {
    if constexpr (A == 0) {
      return std::span<const CellRecord<A>>();
    } else {
      return filtration_.triangulation().template cells<A>();
    }
  }
  void deal(const Columns<D>& columns);
  template <int A, int K>
  void deal_some(std::size_t begin, std::size_t end, std::vector<std::uint32_t>& next,
                 const Columns<D>& columns) const;
  void sort(std::size_t stretch, const Columns<D>& columns, RawVector<Entry>& sorted) const;

  const Filtration<D>& filtration_;
  std::uint32_t last_index_;
  unsigned bits_;
  Threads threads_;
  std::vector<std::uint32_t> begins_;             // [stretch]: in the columns; and the end
  std::vector<std::vector<std::uint32_t>> next_;  // [part][stretch]
};

// Every part of the simplices has places of its own in each stretch.
template <int D>
void ColumnOrder<D>::deal(const Columns<D>& columns) {
  with_affine_dimension(filtration_.triangulation(), [&]<int A>() {
    parallel_parts(threads_, filtration_.size(), next_.size(),
                   [&](std::size_t part, std::size_t begin, std::size_t end) {
                     [&]<int... K>(std::integer_sequence<int, K...>) {
                       (deal_some<A, K>(begin, end, next_[part], columns), ...);
                     }
                     (std::make_integer_sequence<int, A + 1>());
                   });
  });
}

// Those of dimension K among begin..end - 1.
template <int D>
template <int A, int K>
void ColumnOrder<D>::deal_some(std::size_t begin, std::size_t end, std::vector<std::uint32_t>& next,
                               const Columns<D>& columns) const {
  const auto& table = filtration_.table();
  const std::size_t first = table.first(K);
  begin = std::max(begin, first);
  end = std::min(end, first + table.count(K));
  const auto& sites = filtration_.triangulation().sites();
  const SimplexReader<D, A> reader{cells_of<A>(), table};
  const std::span<const std::uint32_t> enters = filtration_.enters();
  for (std::size_t i = begin; i < end; ++i) {
    if (enters[i] > last_index_) continue;
    const std::uint32_t place = next[enters[i] >> bits_]++;
    columns.simplices[place] = SimplexId(static_cast<std::uint32_t>(i));
    columns.rows[place] = rows_of<K>(reader, sites, static_cast<std::uint32_t>(i - first));
    columns.enters[place] = enters[i];
  }
}

template <int D>
void ColumnOrder<D>::sort(std::size_t stretch, const Columns<D>& columns,
                          RawVector<Entry>& sorted) const {
  const std::size_t begin = begins_[stretch], size = begins_[stretch + 1] - begin;
  const std::uint32_t first_index = static_cast<std::uint32_t>(stretch) << bits_;
  std::vector<std::uint32_t> next(std::size_t{1} << bits_, 0);
  for (std::size_t i = begin; i < begin + size; ++i) ++next[columns.enters[i] - first_index];
  std::uint32_t first = 0;
  for (std::uint32_t& place : next) first += std::exchange(place, first);
  if (sorted.size() < size) sorted.resize(size);
  for (std::size_t i = begin; i < begin + size; ++i) {
    sorted[next[columns.enters[i] - first_index]++] = {columns.rows[i], columns.simplices[i],
                                                       columns.enters[i]};
  }
  const auto put = [&](std::size_t from, std::size_t behind, int dimension) {
    const auto tied = std::span(sorted).subspan(from, behind - from);
    if (tied.size() > 1) {
      std::sort(tied.begin(), tied.end(),
                [](const Entry& a, const Entry& b) { return a.rows < b.rows; });
    }
    for (std::size_t i = from; i < behind; ++i) {
      columns.simplices[begin + i] = sorted[i].simplex;
      columns.dimensions[begin + i] = static_cast<std::uint8_t>(dimension);
      columns.rows[begin + i] = sorted[i].rows;
      columns.enters[begin + i] = sorted[i].enters;
    }
  };
  for (std::size_t from = 0; from < size;) {
    const int dimension = filtration_.dimension(sorted[from].simplex);
    std::size_t behind = from + 1;
    while (behind < size && sorted[behind].enters == sorted[from].enters &&
           filtration_.dimension(sorted[behind].simplex) == dimension) {
      ++behind;
    }
    put(from, behind, dimension);
    from = behind;
  }
}

}  // namespace

template <int D>
FilterColumns<D>::FilterColumns(const Filtration<D>& filtration, std::uint32_t index,
                                Threads threads)
    : filtration_(&filtration) {
  ColumnOrder<D> order(filtration, index, threads);
  simplices_.resize(order.size());
  dimensions_.resize(order.size());
  rows_.resize(order.size());
  enters_.resize(order.size());
  order.fill({simplices_, dimensions_, rows_, enters_});
}

template <int D>
RawVector<double> FilterColumns<D>::alpha2(Threads threads) const {
  RawVector<double> result(size());
  for_parts(size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = filtration_->alpha2(enters_[i]);
  });
  return result;
}

template <int D>
RawVector<std::uint32_t> FilterColumns<D>::regular(Threads threads) const {
  RawVector<std::uint32_t> result(size());
  for_parts(size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = filtration_->regular(simplices_[i]);
  });
  return result;
}

template <int D>
RawVector<std::uint32_t> FilterColumns<D>::interior(Threads threads) const {
  RawVector<std::uint32_t> result(size());
  for_parts(size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = filtration_->interior(simplices_[i]);
  });
  return result;
}

template class FilterColumns<2>;
template class FilterColumns<3>;

}  // namespace orthoball
