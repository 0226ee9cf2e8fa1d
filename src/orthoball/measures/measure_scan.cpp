// SPDX-License-Identifier: MIT
//
// Volume: the cells' volumes. Areas: the facets that have entered (E), that have become regular (R)
// and that have become interior (I) give the singular ones E - R and the regular ones R - I. A
// facet becomes regular when the first of its cells enters and interior when the second does, so
// cells change both sums. Length: an edge enters with 2 pi len, a triangle with -pi perimeter, a
// tetrahedron with the sum of len x exterior angle over its edges.
//
// Terms are made along space and wanted along the spectrum. A window is a run of stretches of
// indices. The simplices that enter in it are sought in storage order, measured, and their terms
// dealt out to the stretches; then the terms of each stretch are added to the rows of its indices,
// which stay in the processor's caches. In a stretch that alone has more terms than a window should
// have, a part of the simplices is measured at a time.
#include "orthoball/measures/measure_scan.h"

#include <algorithm>
#include <bit>

#include "orthoball/measures/measure_units.h"
#include "orthoball/measures/window_selection.h"

namespace orthoball {
namespace {

using namespace sum_rows_detail;

constexpr std::array<std::size_t, 3> kTermBytes{TermBins<1>::kBytes, TermBins<2>::kBytes,
                                                TermBins<6>::kBytes};

// Terms that may wait at the same time, as a part of all, and what is little anyway.
constexpr std::size_t kWindowParts = 6;
constexpr std::size_t kSmallWindowBytes = std::size_t{1} << 20U;

// Cells at a time: what they, their facets and edges are made of stays in the nearest caches.
constexpr std::uint32_t kBlock = 2048;

// The tag of a cell's terms by its roles.
constexpr auto kTagOfRoles = [] {
  std::array<std::uint8_t, 256> tags{};
  for (unsigned roles = 0; roles < tags.size(); ++roles) {
    const unsigned second = roles & 15U;
    const unsigned entering = roles >> 4U & ~second;
    tags[roles] =
        static_cast<std::uint8_t>(cell_tag(static_cast<unsigned>(std::popcount(second)),
                                           static_cast<unsigned>(std::popcount(entering))));
  }
  return tags;
}();

}  // namespace

// Seeks simplices of one dimension that enter in the window, measures them and deals out their
// terms, one block of them after the other.
template <int D>
template <class Bins, class Terms>
class MeasureScan<D>::Filler {
 public:
  Filler(const MeasureScan& scan, Sums& sums, Bins& bins, std::size_t part, int dimension)
      : sums_(sums),
        dealer_(bins, part),
        enters_(scan.filtration_->enters().subspan(scan.filtration_->table().first(dimension),
                                                   scan.filtration_->count(dimension))),
        first_(scan.window_.begin * kIndexStretch),
        length_((scan.window_.end - scan.window_.begin) * kIndexStretch) {}

  // @param wanted  bit per simplex; empty for all
  template <class TagOf>
  void fill(std::uint32_t begin, std::uint32_t end, std::span<const std::uint64_t> wanted,
            const TagOf& tag_of) {
    const std::size_t size =
        select_in_window(enters_, begin, end, first_, length_, wanted, wanted_);
    const bool may_be_large = sums_.contributions.may_be_large();
    if (terms_.size() < size) terms_.resize(size);
    if (may_be_large) large_.resize(size);
    sums_.contributions.measure(std::span(wanted_).first(size), terms_, large_);
    constexpr std::size_t kAhead = 16;
    for (std::size_t i = 0; i < size; ++i) {
      dealer_.approach(enters_[wanted_[std::min(i + kAhead, size - 1)]]);
      const std::uint32_t index = enters_[wanted_[i]];
      dealer_.deal(index, tag_of(wanted_[i]), &terms_[i]);
      if (may_be_large) add_large(sums_.large[index - first_], large_[i]);
    }
  }

 private:
  static void add_large(LargeRow& row, const LargeTerms& large) {
    row[kVolume] += large.volume;
    row[kLength] += large.length;
    row[kSingular] += large.singular;
    row[kRegular] += large.regular;
  }

  Sums& sums_;
  typename Bins::Dealer dealer_;
  std::span<const std::uint32_t> enters_;
  std::uint32_t first_, length_;  // of the window
  std::vector<std::uint32_t> wanted_;
  std::vector<Terms> terms_;
  std::vector<LargeTerms> large_;
};

template <int D>
MeasureScan<D>::MeasureScan(const Filtration<D>& filtration, const FacetRoles<D>& roles,
                            Threads threads)
    : filtration_(&filtration), threads_(threads), roles_(roles) {
  for (const Contributions<D>& contributions : contributions_of(filtration, roles.of_cells())) {
    const auto units = [&](int power, int divisor) {
      return input_units(filtration, contributions, power, divisor);
    };
    sums_.emplace_back(contributions, SumUnits{units(D, factorial(D)),
                                               units(D - 1, factorial(D - 1)), units(1, 1)});
    if (contributions.may_be_large()) threads_ = Threads(1);
  }
  count_terms();
  plan_windows();
}

template <int D>
std::uint32_t MeasureScan<D>::stretch_count() const {
  return (filtration_->spectrum_size() >> kIndexStretchBits) + 1;
}

template <int D>
std::uint32_t MeasureScan<D>::end_index() const {
  return std::min(end_stretch_ * kIndexStretch, filtration_->spectrum_size() + 1);
}

// Cuts the simplices into pieces of cells with the facets and edges they own; where there are no
// cells, each kind by itself.
template <int D>
std::vector<typename MeasureScan<D>::Bound> MeasureScan<D>::bounds(std::size_t pieces) const {
  const std::size_t cells = filtration_->count(D);
  std::vector<Bound> result(pieces + 1);
  for (std::size_t i = 0; i <= pieces; ++i) {
    const auto share = [&](std::size_t count) {
      return static_cast<std::uint32_t>(count * i / pieces);
    };
    result[i] = cells == 0
                    ? Bound{share(filtration_->count(1)), share(filtration_->count(D - 1)), 0}
                    : bound_at(share(cells));
  }
  return result;
}

// The first edge and the first facet that the cells from `cell` on own.
template <int D>
typename MeasureScan<D>::Bound MeasureScan<D>::bound_at(std::uint32_t cell) const {
  const SimplexTable<D>& table = filtration_->table();
  const auto first_of = [&](std::span<const std::uint32_t> owners, std::uint32_t places) {
    return static_cast<std::uint32_t>(
        std::lower_bound(owners.begin(), owners.end(), std::uint64_t{cell} * places) -
        owners.begin());
  };
  return {D == 3 ? first_of(table.edge_owners(), 6) : 0U, first_of(table.facet_owners(), 4), cell};
}

template <int D>
void MeasureScan<D>::count_terms() {
  const std::span<const std::uint32_t> enters = filtration_->enters();
  const std::vector<Bound> bound = bounds(threads_.count());
  for (auto& of_kind : term_counts_) {
    of_kind.assign(threads_.count(), std::vector<std::uint32_t>(stretch_count(), 0));
  }
  parallel_for(threads_, threads_.count(), [&](std::size_t part) {
    const auto count = [&](std::size_t kind, int dimension, std::uint32_t begin, std::uint32_t end,
                           const auto& is_wanted) {
      const std::uint32_t* of_kind = enters.data() + filtration_->table().first(dimension);
      std::uint32_t* counts = term_counts_[kind][part].data();
      for (std::uint32_t i = begin; i < end; ++i) {
        counts[of_kind[i] >> kIndexStretchBits] += is_wanted(i) ? 1U : 0U;
      }
    };
    const auto all = [](std::uint32_t) { return true; };
    const Bound &begin = bound[part], &end = bound[part + 1];
    if constexpr (D == 3) count(kEdges, 1, begin.edge, end.edge, all);
    count(kFacets, D - 1, begin.facet, end.facet,
          [&](std::uint32_t facet) { return roles_.is_singular(facet); });
    count(kCells, D, begin.cell, end.cell, all);
  });
}

template <int D>
void MeasureScan<D>::plan_windows() {
  std::vector<std::size_t> bytes(stretch_count(), 0);
  std::size_t total = 0;
  for (std::size_t kind = 0; kind < term_counts_.size(); ++kind) {
    for (const auto& of_part : term_counts_[kind]) {
      for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] += kTermBytes[kind] * of_part[i];
        total += kTermBytes[kind] * of_part[i];
      }
    }
  }
  const std::size_t most = std::max(total / kWindowParts + 1, kSmallWindowBytes);
  // A window has the stretches that end before the same multiple of `most`.
  std::size_t sum = 0;
  for (std::uint32_t begin = 0, end = 0; begin < bytes.size(); begin = end) {
    const std::size_t of_first = bytes[end++];
    sum += of_first;
    const std::size_t multiple = sum / most;
    while (end < bytes.size() && of_first <= most && (sum + bytes[end]) / most == multiple) {
      sum += bytes[end++];
    }
    windows_.push_back({begin, end, of_first / most + 1});
  }
}

// Measures, in storage order, the simplices that enter in the window, or one of its rounds of them,
// and deals out their terms.
template <int D>
void MeasureScan<D>::fill(Sums& sums, std::size_t round) {
  const std::size_t parts = threads_.count();
  const std::vector<Bound> bound = bounds(window_.rounds * parts);
  const auto prepare = [&](auto& bins, std::size_t kind, std::uint32_t Bound::*number) {
    std::vector<std::vector<std::uint32_t>> at_most;
    std::vector<std::span<const std::uint32_t>> counts;
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t piece = round * parts + part;
      at_most.push_back({bound[piece + 1].*number - bound[piece].*number});
      counts.push_back(window_.rounds == 1
                           ? std::span<const std::uint32_t>(term_counts_[kind][part])
                                 .subspan(window_.begin, window_.end - window_.begin)
                           : std::span<const std::uint32_t>(at_most.back()));
    }
    bins.prepare(window_.begin, counts);
  };
  prepare(sums.edges, kEdges, &Bound::edge);
  prepare(sums.facets, kFacets, &Bound::facet);
  prepare(sums.cells, kCells, &Bound::cell);
  parallel_for(threads_, parts, [&](std::size_t part) {
    const std::size_t piece = round * parts + part;
    fill_part(sums, part, bound[piece], bound[piece + 1]);
  });
}

template <int D>
void MeasureScan<D>::fill_part(Sums& sums, std::size_t part, Bound begin, const Bound& end) {
  Filler<TermBins<1>, EdgeTerm> edges(*this, sums, sums.edges, part, 1);
  Filler<TermBins<2>, FacetTerms> facets(*this, sums, sums.facets, part, D - 1);
  Filler<TermBins<6>, CellTerms> cells(*this, sums, sums.cells, part, D);
  const auto no_tag = [](std::uint32_t) { return 0U; };
  while (begin.edge < end.edge || begin.facet < end.facet || begin.cell < end.cell) {
    const Bound stop = end.cell - begin.cell > kBlock ? bound_at(begin.cell + kBlock) : end;
    cells.fill(begin.cell, stop.cell, {},
               [&](std::uint32_t cell) { return unsigned{kTagOfRoles[roles_.of_cells()[cell]]}; });
    facets.fill(begin.facet, stop.facet, roles_.singular(), no_tag);
    if constexpr (D == 3) edges.fill(begin.edge, stop.edge, {}, no_tag);
    begin = stop;
  }
}

template <int D>
void MeasureScan<D>::begin_window(const Window& window) {
  window_ = window;
  for (Sums& sums : sums_) {
    if (sums.contributions.may_be_large()) {
      sums.large.assign((window.end - window.begin) * std::size_t{kIndexStretch}, {});
    }
    if (window.rounds == 1) fill(sums, 0);
  }
}

template <int D>
void MeasureScan<D>::sum_stretch(Sums& sums, std::uint32_t stretch) {
  const std::size_t begin = std::size_t{stretch - first_stretch_} * kIndexStretch;
  const std::span<SumRow> rows = std::span(sums.rows).subspan(
      begin, std::min<std::size_t>(kIndexStretch, sums.rows.size() - begin));
  std::fill(rows.begin(), rows.end(), SumRow{});
  for (auto& of_kind : columns_) {
    std::fill_n(of_kind.begin() + static_cast<std::ptrdiff_t>(begin), rows.size(), 0U);
  }
  const CountRows counts{columns_[kEdges].data() + begin, columns_[kFacets].data() + begin,
                         columns_[kCells].data() + begin, columns_[kInteriorFacets].data() + begin};
  for (std::size_t round = 0; round < window_.rounds; ++round) {
    if (window_.rounds > 1) fill(sums, round);
    add_terms(sums.edges, sums.facets, sums.cells, stretch, rows.data(), counts);
  }
  accumulate(rows);
}

template <int D>
bool MeasureScan<D>::next() {
  if (end_stretch_ == stretch_count()) return false;
  const bool begins_window = end_stretch_ == window_.end;
  if (begins_window) begin_window(windows_[next_window_++]);
  const std::uint32_t at_once = threads_.count() == 1 ? 1U : 4U * threads_.count();
  first_stretch_ = end_stretch_;
  end_stretch_ = std::min(window_.end, first_stretch_ + at_once);
  const std::uint32_t stretches = end_stretch_ - first_stretch_;
  for (auto& of_kind : columns_) of_kind.resize(end_index() - first_index());
  for (Sums& sums : sums_) sums.rows.resize(end_index() - first_index());
  parallel_for(threads_, stretches, [&](std::size_t i) {
    for (Sums& sums : sums_) sum_stretch(sums, first_stretch_ + static_cast<std::uint32_t>(i));
  });
  for (Sums& sums : sums_) {
    sums.before.resize(stretches);
    for (std::uint32_t i = 0; i < stretches; ++i) {
      sums.before[i] = sums.total;
      const std::size_t end =
          std::min<std::size_t>((i + std::size_t{1}) * kIndexStretch, sums.rows.size());
      add_row(sums.total, sums.rows[end - 1]);
    }
    if (!begins_window) continue;
    for (LargeRow& row : sums.large) {
      for (std::size_t lane = 0; lane < row.size(); ++lane) {
        row[lane] = sums.large_before[lane] += row[lane];
      }
    }
  }
  return true;
}

template <int D>
void MeasureScan<D>::measures(std::uint32_t index, std::span<const FacetCounts> facets,
                              std::span<ComplexMeasures> out) const {
  const std::uint32_t place = index - first_index();
  const Sums& front = sums_.front();
  const SumRow& before = front.before[place >> kIndexStretchBits];
  const auto rows = std::span(front.rows).subspan(place, out.size());
  if (front.large.empty()) {
    read_sums(before, rows, front.units, out);
  } else {
    // Each of the preferred sums, unless terms that are part of it are missing.
    const Sums& back = sums_.back();
    std::array<ComplexMeasures, 1> of_front, of_back;
    for (std::size_t i = 0; i < out.size(); ++i) {
      read_sums(before, rows.subspan(i, 1), front.units, of_front);
      read_sums(back.before[place >> kIndexStretchBits], std::span(back.rows).subspan(place + i, 1),
                back.units, of_back);
      const LargeRow& large = front.large[index + i - window_.begin * std::size_t{kIndexStretch}];
      const auto choose = [&](double ComplexMeasures::*which, bool is_missing) {
        out[i].*which = (is_missing ? of_back : of_front)[0].*which;
      };
      choose(&ComplexMeasures::volume, large[kVolume] != 0);
      choose(&ComplexMeasures::length, large[kLength] != 0);
      choose(&ComplexMeasures::area_singular, large[kSingular] != 0);
      choose(&ComplexMeasures::area_regular, large[kRegular] != 0);
      choose(&ComplexMeasures::area, large[kSingular] != 0 || large[kRegular] != 0);
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (facets[i].singular == 0) out[i].area_singular = 0.0;
    if (facets[i].regular == 0) out[i].area_regular = 0.0;
    if ((facets[i].singular | facets[i].regular) == 0) out[i].area = 0.0;
  }
}

template class MeasureScan<2>;
template class MeasureScan<3>;

}  // namespace orthoball
