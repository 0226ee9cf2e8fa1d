// SPDX-License-Identifier: MIT
//
// When every simplex enters, becomes regular and becomes interior, as ranks.
//
// 1. Attached: going down the dimensions, each simplex marks those of its facets beyond which its
//    orthocentre lies; a simplex is attached if any coface marked it.
// 2. Every unattached simplex gets its squared orthoradius as a correctly rounded label and is
//    sorted by it. Labels that differ are in exact order; runs of equal labels are split into
//    classes of exactly equal values, by integers where certified bounds do not separate them. A
//    class is one entry of the spectrum.
// 3. Ranks go down the dimensions: an attached simplex enters with the first of its cofaces; the
//    first proper coface makes a simplex regular, the last cell around it makes it interior.
//
// Edelsbrunner, Muecke. Three-dimensional alpha shapes. ACM Transactions on Graphics 13 (1994).
#include "orthoball/filtration/critical_alpha2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "orthoball/exact/orthoradius.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/edge_ring.h"
#include "orthoball/filtration/label_sort.h"

namespace orthoball {
namespace {

template <int A>
using Cells = std::span<const CellRecord<A>>;

// The corners of a simplex of dimension K by number, in any order, and its facets, facet i opposite
// corner i: how every step below reads the table.
template <int D, int A>
struct SimplexReader {
  Cells<A> cells;
  const SimplexTable<D>& table;
  const typename SimplexTable<D>::EdgesOfCells& edges_of_cells;

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
        result[i] = cells[owner / 4].corners[facet_corner(owner % 4, i)];
      }
    } else {
      const std::uint32_t owner = table.edge_owners()[number];
      const auto [i, j] = kEdgeCorners[owner % 6];
      result = {cells[owner / 6].corners[i], cells[owner / 6].corners[j]};
    }
    return result;
  }

  // Numbers within dimension K - 1.
  template <int K>
  [[nodiscard]] std::array<std::uint32_t, std::size_t{K} + 1> facets(std::uint32_t number) const {
    std::array<std::uint32_t, std::size_t{K} + 1> result;
    if constexpr (K == 1) {
      const auto ends = corners<1>(number);
      result = {ends[1], ends[0]};
    } else if constexpr (K == A) {
      for (unsigned i = 0; i <= K; ++i) {
        result[i] = table.template facet_of_cell<A>(cells, number, i);
      }
    } else {  // a triangle in space
      const std::uint32_t owner = table.facet_owners()[number];
      for (unsigned i = 0; i <= K; ++i) {
        const unsigned corner = facet_corner(owner % 4, i);
        result[i] = edges_of_cells[owner / 4][5U - kEdgeSlot[corner][owner % 4]];
      }
    }
    return result;
  }

 private:
  // Corner i of the facet opposite a corner.
  static unsigned facet_corner(unsigned opposite, unsigned i) {
    return i + (i >= opposite ? 1 : 0);
  }
};

// -0 stands for negative values too small for a double, which are less than what 0 stands for.
bool is_same_label(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

template <int D, int A>
class Builder {
 public:
  Builder(const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
          const typename SimplexTable<D>::EdgesOfCells& edges_of_cells)
      : sites_(triangulation.sites()), table_(table), reader_{{}, table, edges_of_cells} {
    if constexpr (A >= 1) reader_.cells = triangulation.template cells<A>();
  }

  CriticalAlpha2 build() {
    result_.is_attached.assign(table_.size(), false);
    if constexpr (A >= 3) mark_attached_facets<3>();
    if constexpr (A >= 2) mark_attached_facets<2>();
    if constexpr (A >= 1) {
      if (!sites_.is_unweighted()) mark_attached_facets<1>();
    }
    label_all();
    rank();
    hand_down();
    return std::move(result_);
  }

 private:
  template <int K>
  void mark_attached_facets();
  template <int K>
  void label();
  void label_all();
  void rank();
  void rank_run(std::span<std::uint32_t> simplices, double label);
  [[nodiscard]] bool is_one_class(std::span<const std::uint32_t> simplices) const;
  void rank_exactly(std::span<std::uint32_t> simplices, double label);
  void enter_together(std::span<const std::uint32_t> simplices, double label);
  [[nodiscard]] FewOf<std::uint32_t, D> corners(std::uint32_t simplex) const;
  void hand_down();
  template <int K>
  void hand_down_regular();
  void hand_down_interior();

  [[nodiscard]] std::uint32_t first(int dimension) const { return table_.first(dimension); }
  [[nodiscard]] std::uint32_t count(int dimension) const {
    return static_cast<std::uint32_t>(table_.count(dimension));
  }

  const Sites<D>& sites_;
  const SimplexTable<D>& table_;
  SimplexReader<D, A> reader_;
  // Labels of the unattached simplices, both in the order of their simplices, then sorted. While
  // ranks are given, the labels in front become the spectrum, of which there are never more.
  std::vector<double> labels_;
  std::vector<std::uint32_t> simplices_;
  std::uint32_t last_index_ = 0;
  CriticalAlpha2 result_;
};

template <int D, int A>
template <int K>
void Builder<D, A>::mark_attached_facets() {
  for (std::uint32_t number = 0; number < count(K); ++number) {
    const unsigned mask =
        attached_facets<D, std::size_t{K} + 1>(sites_, reader_.template corners<K>(number));
    if (mask == 0) continue;
    const auto facets = reader_.template facets<K>(number);
    for (unsigned i = 0; i <= K; ++i) {
      if ((mask >> i & 1U) != 0) result_.is_attached[first(K - 1) + facets[i]] = true;
    }
  }
}

// --- labels and ranks --------------------------------------------------------------------------

template <int D, int A>
template <int K>
void Builder<D, A>::label() {
  constexpr std::size_t kBlock = 256;
  std::array<CornerSites<std::size_t{K} + 1>, kBlock> simplices;
  std::size_t size = 0;
  const auto flush = [&] {
    const std::size_t done = labels_.size();
    labels_.resize(done + size);
    squared_orthoradii<D, std::size_t{K} + 1>(sites_, std::span(simplices).first(size),
                                              std::span(labels_).subspan(done));
    size = 0;
  };
  for (std::uint32_t number = 0; number < count(K); ++number) {
    if (result_.is_attached[first(K) + number]) continue;
    simplices_.push_back(first(K) + number);
    simplices[size] = reader_.template corners<K>(number);
    if (++size == kBlock) flush();
  }
  flush();
}

template <int D, int A>
void Builder<D, A>::label_all() {
  const auto attached = std::count(result_.is_attached.begin(), result_.is_attached.end(), true);
  const std::size_t unattached = table_.size() - static_cast<std::size_t>(attached);
  labels_.reserve(unattached);
  simplices_.reserve(unattached);
  label<0>();
  if constexpr (A >= 1) label<1>();
  if constexpr (A >= 2) label<2>();
  if constexpr (A >= 3) label<3>();
}

template <int D, int A>
FewOf<std::uint32_t, D> Builder<D, A>::corners(std::uint32_t simplex) const {
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
inline void Builder<D, A>::enter_together(std::span<const std::uint32_t> simplices, double label) {
  labels_[last_index_++] = label + 0.0;  // a negative value that rounds to -0 reads 0
  for (const std::uint32_t simplex : simplices) result_.enters[simplex] = last_index_;
}

// Ranks simplices with one label. Most runs of more than one are one class, which takes one pass.
// Others are cut wherever the bounds of what rounding took from the labels leave a gap: so of many
// values that share a label, as of cells that nearly share a sphere, few are compared in integers.
template <int D, int A>
void Builder<D, A>::rank_run(std::span<std::uint32_t> simplices, double label) {
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
bool Builder<D, A>::is_one_class(std::span<const std::uint32_t> simplices) const {
  const auto first = corners(simplices[0]);
  const OrthoradiusPivot<D> pivot(sites_, {first.begin(), first.size()});
  return std::all_of(simplices.begin() + 1, simplices.end(), [&](std::uint32_t simplex) {
    const auto mine = corners(simplex);
    return pivot.compare({mine.begin(), mine.size()}) == Sign::zero;
  });
}

// Quicksort in three parts by the exact comparison with one pivot.
template <int D, int A>
void Builder<D, A>::rank_exactly(std::span<std::uint32_t> simplices, double label) {
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
void Builder<D, A>::rank() {
  sort_labels(labels_, simplices_);
  result_.enters.assign(table_.size(), 0xFFFFFFFFU);  // later than every index
  for (std::size_t begin = 0; begin < labels_.size();) {
    const double label = labels_[begin];
    std::size_t end = begin + 1;
    while (end < labels_.size() && is_same_label(labels_[end], label)) ++end;
    rank_run(std::span(simplices_).subspan(begin, end - begin), label);
    begin = end;
  }
  simplices_ = {};
  labels_.resize(last_index_);
  labels_.shrink_to_fit();
  result_.spectrum = std::move(labels_);
}

// --- down the dimensions -----------------------------------------------------------------------

// First proper cofaces of the (K - 1)-simplices, whose enters follow where they are attached.
template <int D, int A>
template <int K>
void Builder<D, A>::hand_down_regular() {
  for (std::uint32_t number = 0; number < count(K); ++number) {
    const std::uint32_t index = result_.enters[first(K) + number];
    for (const std::uint32_t facet : reader_.template facets<K>(number)) {
      std::uint32_t& regular = result_.regular[first(K - 1) + facet];
      regular = std::min(regular, index);
    }
  }
  for (std::uint32_t facet = first(K - 1); facet < first(K); ++facet) {
    if (result_.is_attached[facet]) result_.enters[facet] = result_.regular[facet];
  }
}

// Last cells around every simplex; never where one of its cofaces is a facet of the hull.
template <int D, int A>
void Builder<D, A>::hand_down_interior() {
  const auto never = static_cast<std::uint32_t>(result_.spectrum.size()) + 1;
  const auto raise = [&](int dimension, std::uint32_t number, std::uint32_t index) {
    std::uint32_t& interior = result_.interior[first(dimension) + number];
    interior = std::max(interior, index);
  };
  for (std::uint32_t cell = 0; cell < count(A); ++cell) {
    const CellRecord<A>& record = reader_.cells[cell];
    const std::uint32_t index = result_.enters[first(A) + cell];
    for (unsigned corner = 0; corner <= A; ++corner) {
      raise(0, record.corners[corner], index);
      const bool is_hull = record.neighbours[corner] == kOutside;
      const std::uint32_t reached = is_hull ? never : index;
      if constexpr (A >= 2) {
        raise(A - 1, table_.template facet_of_cell<A>(reader_.cells, cell, corner), reached);
      }
      if (!is_hull) continue;
      for (unsigned other = 0; other <= A; ++other) {
        if (other == corner) continue;
        raise(0, record.corners[other], never);
        if constexpr (A == 3) {
          raise(1, reader_.edges_of_cells[cell][5U - kEdgeSlot[corner][other]], never);
        }
      }
    }
    if constexpr (A == 3) {
      for (const std::uint32_t edge : reader_.edges_of_cells[cell]) raise(1, edge, index);
    }
  }
}

template <int D, int A>
void Builder<D, A>::hand_down() {
  const auto never = static_cast<std::uint32_t>(result_.spectrum.size()) + 1;
  result_.regular.assign(first(A), never);
  if constexpr (A >= 3) hand_down_regular<3>();
  if constexpr (A >= 2) hand_down_regular<2>();
  if constexpr (A >= 1) hand_down_regular<1>();
  result_.interior.assign(first(A), A == D ? 0 : never);
  if constexpr (A == D) hand_down_interior();
}

}  // namespace

template <int D>
CriticalAlpha2 critical_alpha2(const RegularTriangulation<D>& triangulation,
                               const SimplexTable<D>& table,
                               const typename SimplexTable<D>::EdgesOfCells& edges_of_cells) {
  CriticalAlpha2 result;
  with_affine_dimension(triangulation, [&]<int A>() {
    result = Builder<D, A>(triangulation, table, edges_of_cells).build();
  });
  return result;
}

template CriticalAlpha2 critical_alpha2<2>(const RegularTriangulation<2>&, const SimplexTable<2>&,
                                           const SimplexTable<2>::EdgesOfCells&);
template CriticalAlpha2 critical_alpha2<3>(const RegularTriangulation<3>&, const SimplexTable<3>&,
                                           const SimplexTable<3>::EdgesOfCells&);

}  // namespace orthoball
