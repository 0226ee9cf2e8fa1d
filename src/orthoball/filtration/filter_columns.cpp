// SPDX-License-Identifier: MIT
//
// Rows are found fast where simplices lie in memory, near their neighbours in space, and written to
// where they belong. Only then ties are put in order, which are neighbours by now: everything but
// that one write goes along memory.
#include "orthoball/filtration/filter_columns.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "orthoball/filtration/filter.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kBeyond = 0xFFFFFFFFU;             // position of what is left out
constexpr std::size_t kLeastPart = std::size_t{1} << 14U;  // simplices for a thread of its own

// Calls `visit(begin, end)` for parts of 0..size - 1, on as many threads as are worth it.
template <class Visit>
void for_parts(std::size_t size, Threads threads, const Visit& visit) {
  const Threads used = threads.for_work(size, kLeastPart);
  parallel_parts(used, size, used.count(),
                 [&](std::size_t, std::size_t begin, std::size_t end) { visit(begin, end); });
}

constexpr std::size_t kAhead = 24;  // simplices between asking for memory and using it

template <int D>
using Rows = std::array<SiteId, std::size_t{D} + 1>;

template <int D>
Rows<D> rows_of(const Filtration<D>& filtration, std::size_t simplex) {
  const auto few = filtration.rows(SimplexId(static_cast<std::uint32_t>(simplex)));
  Rows<D> rows;  // filled up with none
  for (std::size_t i = 0; i <= D; ++i) {
    if (i < few.size()) rows[i] = few[i];
  }
  return rows;
}

// Puts the simplices of one index and dimension in the order of their rows.
template <int D>
void sort_tie(std::span<SimplexId> simplices, std::span<SiteId> rows) {
  constexpr std::size_t kWidth = std::size_t{D} + 1;
  struct Keyed {
    Rows<D> rows;
    SimplexId simplex;
  };
  std::vector<Keyed> tied(simplices.size());
  for (std::size_t i = 0; i < tied.size(); ++i) {
    std::copy_n(&rows[kWidth * i], kWidth, tied[i].rows.begin());
    tied[i].simplex = simplices[i];
  }
  std::sort(tied.begin(), tied.end(),
            [](const Keyed& a, const Keyed& b) { return a.rows < b.rows; });
  for (std::size_t i = 0; i < tied.size(); ++i) {
    std::copy_n(tied[i].rows.begin(), kWidth, &rows[kWidth * i]);
    simplices[i] = tied[i].simplex;
  }
}

}  // namespace

template <int D>
FilterColumns<D>::FilterColumns(const Filtration<D>& filtration, std::uint32_t index,
                                Threads threads)
    : filtration_(&filtration) {
  constexpr std::size_t kWidth = std::size_t{D} + 1;
  {
    const Filter<D> filter(filtration, threads);
    const std::size_t size = filter.complex_size(index);
    simplices_.resize(size);
    std::copy_n(filter.simplices().begin(), size, simplices_.begin());
  }
  dimensions_.resize(size());
  rows_.resize(kWidth * size());
  enters_.resize(size());
  RawVector<std::uint32_t> position(filtration.size());  // [simplex]
  if (size() < position.size()) std::fill(position.begin(), position.end(), kBeyond);
  const std::span<const std::uint32_t> enters = filtration.enters();
  for_parts(size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kAhead < end) {
        __builtin_prefetch(&position[simplices_[i + kAhead].row()], 1);
        __builtin_prefetch(&enters[simplices_[i + kAhead].row()]);
      }
      const SimplexId simplex = simplices_[i];
      position[simplex.row()] = static_cast<std::uint32_t>(i);
      enters_[i] = enters[simplex.row()];
      dimensions_[i] = static_cast<std::uint8_t>(filtration.dimension(simplex));
    }
  });
  for_parts(position.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kAhead < end && position[i + kAhead] != kBeyond) {
        __builtin_prefetch(&rows_[kWidth * position[i + kAhead]], 1);
      }
      if (position[i] == kBeyond) continue;
      const Rows<D> rows = rows_of(filtration, i);
      std::memcpy(static_cast<void*>(&rows_[kWidth * position[i]]), rows.data(), sizeof(rows));
    }
  });
  const auto is_tied = [&](std::size_t a, std::size_t b) {
    return enters_[a] == enters_[b] && dimensions_[a] == dimensions_[b];
  };
  // A tie belongs to the part in which it begins.
  for_parts(size(), threads, [&](std::size_t begin, std::size_t end) {
    while (begin > 0 && begin < end && is_tied(begin - 1, begin)) ++begin;
    while (begin < end) {
      std::size_t behind = begin + 1;
      while (behind < size() && is_tied(begin, behind)) ++behind;
      if (behind - begin > 1) {
        sort_tie<D>(std::span(simplices_).subspan(begin, behind - begin),
                    std::span(rows_).subspan(kWidth * begin, kWidth * (behind - begin)));
      }
      begin = behind;
    }
  });
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
