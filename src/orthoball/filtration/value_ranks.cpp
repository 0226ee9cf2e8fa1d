// SPDX-License-Identifier: MIT
//
// Every simplex that is not attached gets its squared orthoradius as a correctly rounded label and
// is sorted by it. Labels that differ are in exact order; runs of equal labels are split into
// classes of exactly equal values, by integers where certified bounds do not separate them. A class
// is one entry of the spectrum.
#include "orthoball/filtration/value_ranks.h"

#include <algorithm>
#include <array>
#include <span>

#include "orthoball/exact/orthoradius.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/edge_ring.h"
#include "orthoball/filtration/label_buckets.h"

namespace orthoball {
namespace {

template <int A>
using Cells = std::span<const CellRecord<A>>;

// The corners of a simplex of dimension K by number, in any order.
template <int D, int A>
struct SimplexReader {
  Cells<A> cells;
  const SimplexTable<D>& table;

  template <int K>
  [[nodiscard]] CornerSites<std::size_t{K} + 1> corners(std::uint32_t number) const {
    CornerSites<std::size_t{K} + 1> result;
    if constexpr (K == 0) {
      result[0] = number;
    } else if constexpr (K == A) {
      result = cells[number].corners;
    } else if constexpr (K == A - 1) {
      const std::uint32_t owner = table.facet_owners()[number];
      for (unsigned i = 0; i <= K; ++i) {
        result[i] = cells[owner / 4].corners[i + (i >= owner % 4 ? 1 : 0)];
      }
    } else {
      const std::uint32_t owner = table.edge_owners()[number];
      const auto [i, j] = kEdgeCorners[owner % 6];
      result = {cells[owner / 6].corners[i], cells[owner / 6].corners[j]};
    }
    return result;
  }
};

template <int D, int A>
class Ranking {
 public:
  Ranking(const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
          const std::vector<bool>& is_attached)
      : sites_(triangulation.sites()),
        table_(table),
        is_attached_(is_attached),
        reader_{{}, table} {
    if constexpr (A >= 1) reader_.cells = triangulation.template cells<A>();
  }

  ValueRanks ranks() {
    rank(labels());
    return std::move(result_);
  }

 private:
  [[nodiscard]] LabelBuckets labels() const;
  [[nodiscard]] std::vector<double> sample_of_labels() const;
  template <int K>
  void add_labels(LabelBuckets& labels) const;
  void rank(const LabelBuckets& labels);
  void rank_run(std::span<std::uint32_t> simplices, double label);
  [[nodiscard]] bool is_one_class(std::span<const std::uint32_t> simplices) const;
  void rank_exactly(std::span<std::uint32_t> simplices, double label);
  void enter_together(std::span<const std::uint32_t> simplices, double label);
  [[nodiscard]] FewOf<std::uint32_t, D> corners(std::uint32_t simplex) const;

  [[nodiscard]] std::uint32_t first(int dimension) const { return table_.first(dimension); }
  [[nodiscard]] std::uint32_t count(int dimension) const {
    return static_cast<std::uint32_t>(table_.count(dimension));
  }

  const Sites<D>& sites_;
  const SimplexTable<D>& table_;
  const std::vector<bool>& is_attached_;
  SimplexReader<D, A> reader_;
  ValueRanks result_;
};

// --- labels and ranks --------------------------------------------------------------------------

template <int D, int A>
template <int K>
void Ranking<D, A>::add_labels(LabelBuckets& labels) const {
  constexpr std::size_t kBlock = 256;
  std::array<CornerSites<std::size_t{K} + 1>, kBlock> corners;
  std::array<std::uint32_t, kBlock> simplices;
  std::array<double, kBlock> found;
  std::size_t size = 0;
  const auto flush = [&] {
    squared_orthoradii<D, std::size_t{K} + 1>(sites_, std::span(corners).first(size), found);
    for (std::size_t i = 0; i < size; ++i) labels.add(found[i], simplices[i]);
    size = 0;
  };
  for (std::uint32_t number = 0; number < count(K); ++number) {
    // What is attached is written over by the next: whether it is is hard to foretell.
    simplices[size] = first(K) + number;
    corners[size] = reader_.template corners<K>(number);
    size += is_attached_[first(K) + number] ? 0U : 1U;
    if (size == kBlock) flush();
  }
  flush();
}

// Of some cells far apart and one face of each dimension of each.
template <int D, int A>
std::vector<double> Ranking<D, A>::sample_of_labels() const {
  constexpr std::uint32_t kCells = 2048;
  std::vector<double> result;
  const auto add = [&]<std::size_t Corners>(const CornerSites<Corners>& simplex) {
    result.push_back(0.0);
    squared_orthoradii<D, Corners>(sites_, {&simplex, 1}, std::span(result).last(1));
  };
  for (std::uint32_t cell = 0; cell < count(A); cell += count(A) / kCells + 1) {
    const auto all = reader_.template corners<A>(cell);
    add(all);
    if constexpr (A >= 2) add(CornerSites<2>{all[0], all[1]});
    if constexpr (A >= 3) add(CornerSites<3>{all[0], all[1], all[2]});
  }
  return result;
}

template <int D, int A>
LabelBuckets Ranking<D, A>::labels() const {
  LabelBuckets result(table_.size(), sample_of_labels());
  add_labels<0>(result);
  if constexpr (A >= 1) add_labels<1>(result);
  if constexpr (A >= 2) add_labels<2>(result);
  if constexpr (A >= 3) add_labels<3>(result);
  return result;
}

template <int D, int A>
FewOf<std::uint32_t, D> Ranking<D, A>::corners(std::uint32_t simplex) const {
  FewOf<std::uint32_t, D> result;
  const int dimension = table_.dimension(SimplexId(simplex));
  const std::uint32_t number = simplex - first(dimension);
  const auto take = [&](const auto& sites) {
    for (const std::uint32_t site : sites) result.push_back(site);
  };
  if (dimension == 0) take(reader_.template corners<0>(number));
  if constexpr (A >= 1) {
    if (dimension == 1) take(reader_.template corners<1>(number));
  }
  if constexpr (A >= 2) {
    if (dimension == 2) take(reader_.template corners<2>(number));
  }
  if constexpr (A >= 3) {
    if (dimension == 3) take(reader_.template corners<3>(number));
  }
  return result;
}

template <int D, int A>
inline void Ranking<D, A>::enter_together(std::span<const std::uint32_t> simplices, double label) {
  result_.spectrum.push_back(label + 0.0);  // a negative value that rounds to -0 reads 0
  const auto index = static_cast<std::uint32_t>(result_.spectrum.size());
  for (const std::uint32_t simplex : simplices) result_.enters[simplex] = index;
}

// Ranks simplices with one label. Most runs of more than one are one class, which takes one pass.
// Others are cut wherever the bounds of what rounding took from the labels leave a gap: so of many
// values that share a label, as of cells that nearly share a sphere, few are compared in integers.
template <int D, int A>
void Ranking<D, A>::rank_run(std::span<std::uint32_t> simplices, double label) {
  if (simplices.size() == 1 || is_one_class(simplices)) return enter_together(simplices, label);
  struct Bounded {
    Bounds remainder;
    std::uint32_t simplex;
  };
  std::vector<Bounded> bounded;
  bounded.reserve(simplices.size());
  for (const std::uint32_t simplex : simplices) {
    const auto mine = corners(simplex);
    bounded.push_back({label_remainder<D>(sites_, {mine.begin(), mine.size()}, label), simplex});
  }
  std::sort(bounded.begin(), bounded.end(), [](const Bounded& a, const Bounded& b) {
    return a.remainder.least < b.remainder.least;
  });
  for (std::size_t i = 0; i < bounded.size(); ++i) simplices[i] = bounded[i].simplex;
  for (std::size_t begin = 0; begin < bounded.size();) {
    double most = bounded[begin].remainder.most;
    std::size_t end = begin + 1;
    for (; end < bounded.size() && bounded[end].remainder.least <= most; ++end) {
      most = std::max(most, bounded[end].remainder.most);
    }
    rank_exactly(simplices.subspan(begin, end - begin), label);
    begin = end;
  }
}

template <int D, int A>
bool Ranking<D, A>::is_one_class(std::span<const std::uint32_t> simplices) const {
  const auto is_vertex = [&](std::uint32_t simplex) { return simplex < count(0); };
  if (sites_.is_unweighted() && std::all_of(simplices.begin(), simplices.end(), is_vertex)) {
    return true;
  }
  const auto first = corners(simplices[0]);
  const OrthoradiusPivot<D> pivot(sites_, {first.begin(), first.size()});
  return std::all_of(simplices.begin() + 1, simplices.end(), [&](std::uint32_t simplex) {
    const auto mine = corners(simplex);
    return pivot.compare({mine.begin(), mine.size()}) == Sign::zero;
  });
}

// Quicksort in three parts by the exact comparison with one pivot.
template <int D, int A>
void Ranking<D, A>::rank_exactly(std::span<std::uint32_t> simplices, double label) {
  while (simplices.size() > 1) {
    const auto pivot_corners = corners(simplices[simplices.size() / 2]);
    const OrthoradiusPivot<D> pivot(sites_, {pivot_corners.begin(), pivot_corners.size()});
    std::size_t equal = 0;                   // [0, equal): less
    std::size_t next = 0;                    // [equal, next): equal
    std::size_t greater = simplices.size();  // [greater, size): greater
    while (next < greater) {
      const auto mine = corners(simplices[next]);
      const Sign sign = pivot.compare({mine.begin(), mine.size()});
      if (sign == Sign::negative) {
        std::swap(simplices[equal++], simplices[next++]);
      } else if (sign == Sign::positive) {
        std::swap(simplices[next], simplices[--greater]);
      } else {
        ++next;
      }
    }
    rank_exactly(simplices.first(equal), label);
    enter_together(simplices.subspan(equal, greater - equal), label);
    simplices = simplices.subspan(greater);
  }
  if (!simplices.empty()) enter_together(simplices, label);
}

template <int D, int A>
void Ranking<D, A>::rank(const LabelBuckets& labels) {
  constexpr std::size_t kAhead = 24;  // simplices of one part are far from each other
  result_.enters.resize(table_.size());
  result_.spectrum.reserve(labels.size());
  labels.for_each_part(
      [&](std::span<const std::uint64_t> keys, std::span<std::uint32_t> simplices) {
        for (std::size_t begin = 0; begin < keys.size();) {
          const std::size_t ahead = std::min(begin + kAhead, keys.size() - 1);
          __builtin_prefetch(&result_.enters[simplices[ahead]], 1);
          std::size_t end = begin + 1;
          // -0 stands for negative values too small for a double, less than what 0 stands for.
          while (end < keys.size() && keys[end] == keys[begin]) ++end;
          rank_run(simplices.subspan(begin, end - begin), number_of_key(keys[begin]));
          begin = end;
        }
      });
}

}  // namespace

template <int D>
ValueRanks value_ranks(const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
                       const std::vector<bool>& is_attached) {
  ValueRanks result;
  with_affine_dimension(triangulation, [&]<int A>() {
    result = Ranking<D, A>(triangulation, table, is_attached).ranks();
  });
  return result;
}

template ValueRanks value_ranks<2>(const RegularTriangulation<2>&, const SimplexTable<2>&,
                                   const std::vector<bool>&);
template ValueRanks value_ranks<3>(const RegularTriangulation<3>&, const SimplexTable<3>&,
                                   const std::vector<bool>&);

}  // namespace orthoball
