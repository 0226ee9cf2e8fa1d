// SPDX-License-Identifier: MIT
//
// Simplices are measured in batches: loaded into lanes, measured side by side (measure_lanes.h) and
// written out again. In units that may not suit doubles each is loaded in a unit of its own.
#include "orthoball/measures/contributions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "orthoball/filtration/face_vertices.h"
#include "orthoball/measures/measure_lanes.h"
#include "orthoball/measures/thin_cell.h"

namespace orthoball {
namespace {

using namespace measure_lanes_detail;

// Where the coordinates come from and in which unit contributions are wanted.
template <int D>
struct Source {
  const Sites<D>& sites;
  bool is_wide;
  int unit_exponent;

  // Measures the simplices of all lanes, of which so many are needed.
  template <std::size_t N, class Rows>
  void measure(const std::array<Vertices<N>, kLanes>& vertices, std::size_t lanes,
               const BitsRow* roles, Batch<D, N>& batch, Rows& rows) const {
    if (is_wide) {
      for (std::size_t lane = 0; lane < lanes; ++lane) load_wide(vertices[lane], lane, batch);
    }
    measure_lanes_detail::measure(is_wide ? nullptr : sites.span().data(), vertices, roles, batch,
                                  rows);
  }

 private:
  // A simplex moved to the origin and scaled by a power of two to a size between 1/2 and 1.
  template <std::size_t N>
  void load_wide(const Vertices<N>& vertices, std::size_t lane, Batch<D, N>& batch) const {
    std::array<ExactSite<D>, N> exact;
    double farthest = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      exact[i] = sites.exact(vertices[i]);
      for (const double x : exact[i].x) farthest = std::max(farthest, std::abs(x));
    }
    const int halved = farthest > 0x1p+1000 ? 1 : 0;  // so that differences do not overflow
    const double factor = halved == 1 ? 0.5 : 1.0;
    double largest = 0.0;
    for (std::size_t i = N; i-- > 0;) {
      for (std::size_t axis = 0; axis < D; ++axis) {
        exact[i].x[axis] = factor * exact[i].x[axis] - factor * exact[0].x[axis];
        largest = std::max(largest, std::abs(exact[i].x[axis]));
      }
    }
    const int size = largest > 0.0 ? std::ilogb(largest) + 1 : 0;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t axis = 0; axis < D; ++axis) {
        batch.x[i][axis][lane] = std::ldexp(exact[i].x[axis], -size);
      }
    }
    batch.exponent[lane] = size + halved + unit_exponent - sites.exact_scale_exponent();
  }
};

// Loads, measures and stores batch after batch.
// approach(simplex, step) takes one more step, 0 or 1, to bringing what a simplex is made of nearer
// to the processor, load(simplex, lane) fills a lane, store(lane, place) writes one out.
template <class Approach, class Load, class Measure, class Store>
void in_batches(std::span<const std::uint32_t> simplices, const Approach& approach,
                const Load& load, const Measure& measure, const Store& store) {
  const std::size_t size = simplices.size();
  const auto approach_from = [&](std::size_t begin, unsigned step) __attribute__((always_inline)) {
    const std::size_t end = std::min(begin + kLanes, size);
    for (std::size_t i = begin; i < end; ++i) approach(simplices[i], step);
  };
  for (std::size_t begin = 0; begin < size; begin += kLanes) {
    const std::size_t lanes = std::min(kLanes, size - begin);
    approach_from(begin + 2 * kLanes, 0);
    approach_from(begin + kLanes, 1);
    for (std::size_t lane = 0; lane < lanes; ++lane) load(simplices[begin + lane], lane);
    measure(lanes);
    for (std::size_t lane = 0; lane < lanes; ++lane) store(lane, begin + lane);
  }
}

// `term`, or 0 if it is too large; then `count` grows by `step`.
double unless_large(double term, std::int8_t& count, int step) {
  if (std::abs(term) <= Contributions<3>::kLargestTerm) return term;
  count = static_cast<std::int8_t>(count + step);
  return 0.0;
}

// The areas and perimeters of a cell's facets as the facets themselves give them, each in its own
// scale: in the cell's scale a small one may vanish. Adds them to the terms of the cell.
template <int D>
void measure_facets_alone(const Source<D>& source, const Vertices<kCorners<D>>& vertices,
                          unsigned roles, CellTerms& cell, LargeTerms& large) {
  std::array<Vertices<kCorners<D> - 1>, kLanes> facets{};
  for (std::size_t i = 0; i < kCorners<D>; ++i) {
    for (std::size_t j = 0; j < D; ++j) facets[i][j] = vertices[j < i ? j : j + 1];
  }
  Batch<D, kCorners<D> - 1> batch{};
  FacetRows rows;
  source.measure(facets, kCorners<D>, nullptr, batch, rows);
  const auto add = [](double term, double& sum, double& error) {
    const Exactly exactly = two_sum(sum, term);
    sum = exactly.high;
    error += exactly.low;
  };
  for (std::size_t i = 0; i < kCorners<D>; ++i) {
    const bool is_second = (roles >> i & FacetRoles<D>::kIsSecond) != 0;
    const bool is_singular = (roles >> i & FacetRoles<D>::kEntersWith) == 0;
    const double area = std::ldexp(rows.area[i], (D - 1) * batch.exponent[i]);
    const double regular = unless_large(area, large.regular, is_second ? -1 : 1);
    add(is_second ? -regular : regular, cell.regular, cell.regular_error);
    if (is_second) continue;
    if (is_singular) {
      add(-unless_large(area, large.singular, -1), cell.singular, cell.singular_error);
    } else {
      const double perimeter = std::ldexp(rows.perimeter[i], batch.exponent[i]);
      cell.length -= unless_large(perimeter, large.length, 1);
    }
  }
}

}  // namespace

template <int D>
Contributions<D>::Contributions(const Filtration<D>& filtration,
                                std::span<const std::uint8_t> roles)
    : filtration_(&filtration),
      roles_(roles),
      unit_exponent_(filtration.triangulation().sites().scale_exponent()) {}

template <int D>
Contributions<D>::Contributions(const Filtration<D>& filtration,
                                std::span<const std::uint8_t> roles, int unit_exponent)
    : filtration_(&filtration), roles_(roles), is_wide_(true), unit_exponent_(unit_exponent) {}

template <int D>
void Contributions<D>::measure(std::span<const std::uint32_t> cells, std::span<CellTerms> out,
                               std::span<LargeTerms> large) const {
  const auto records = filtration_->triangulation().template cells<D>();
  const Source<D> source{filtration_->triangulation().sites(), is_wide_, unit_exponent_};
  Batch<D, kCorners<D>> batch{};
  BitsRow roles{};
  CellRows<D> rows;
  std::array<Vertices<kCorners<D>>, kLanes> vertices{};

  const auto approach = [&](std::uint32_t cell, unsigned step) __attribute__((always_inline)) {
    const CellRecord<D>& record = records[cell];
    if (step == 0) return __builtin_prefetch(&record);
    for (const std::uint32_t corner : record.corners) __builtin_prefetch(&source.sites[corner]);
  };
  const auto load = [&](std::uint32_t cell, std::size_t lane) {
    // Corners ascend but for the last two.
    vertices[lane] = records[cell].corners;
    const std::uint32_t a = vertices[lane][D - 1], b = vertices[lane][D];
    vertices[lane][D - 1] = std::min(a, b);
    vertices[lane][D] = std::max(a, b);
    const unsigned bits = roles_.empty() ? 0U : roles_[cell];
    const unsigned changed = b < a ? (bits >> 1U ^ bits) & 0x11U << (D - 1) : 0U;
    roles[lane] = bits ^ changed ^ changed << 1U;
  };
  const auto store = [&](std::size_t lane, std::size_t place) {
    CellTerms& cell = out[place];
    cell.volume = rows.volume[lane];
    cell.length = rows.length[lane] + rows.perimeter[lane];
    cell.singular = rows.singular[lane];
    cell.regular = rows.regular[lane];
    cell.singular_error = rows.singular_error[lane];
    cell.regular_error = rows.regular_error[lane];
    const bool is_thin = D == 3 && rows.excess[lane] < 0.0;
    if (!is_wide_ && !is_thin) return;
    double volume = 0.0, length = 0.0;
    if constexpr (D == 3) {
      const ThinCell thin = thin_cell(source.sites, vertices[lane],
                                      source.sites.exact_scale_exponent() - unit_exponent_);
      volume = thin.volume;
      length = thin.length;
    } else {
      volume = std::ldexp(cell.volume, D * batch.exponent[lane]);
    }
    if (!is_wide_) {
      cell.volume = volume;
      cell.length = length + rows.perimeter[lane];
      return;
    }
    large[place] = {};
    cell = {};
    cell.volume = unless_large(volume, large[place].volume, 1);
    cell.length = unless_large(length, large[place].length, 1);
    measure_facets_alone(source, vertices[lane], static_cast<unsigned>(roles[lane]), cell,
                         large[place]);
  };
  in_batches(
      cells, approach, load,
      [&](std::size_t lanes) { source.measure(vertices, lanes, &roles, batch, rows); }, store);
}

template <int D>
void Contributions<D>::measure(std::span<const std::uint32_t> facets, std::span<FacetTerms> out,
                               std::span<LargeTerms> large) const {
  const Source<D> source{filtration_->triangulation().sites(), is_wide_, unit_exponent_};
  const std::uint32_t first = filtration_->table().first(D - 1);
  std::array<Vertices<kCorners<D> - 1>, kLanes> vertices{};
  Batch<D, kCorners<D> - 1> batch{};
  FacetRows rows;
  in_batches(
      facets, [](std::uint32_t, unsigned) {},
      [&](std::uint32_t facet, std::size_t lane) {
        vertices[lane] = face_vertices<kCorners<D> - 1>(*filtration_, SimplexId(first + facet));
      },
      [&](std::size_t lanes) { source.measure(vertices, lanes, nullptr, batch, rows); },
      [&](std::size_t lane, std::size_t place) {
        out[place] = {-rows.perimeter[lane], rows.area[lane]};
        if (!is_wide_) return;
        FacetTerms& terms = out[place];
        large[place] = {};
        terms.area = unless_large(std::ldexp(terms.area, (D - 1) * batch.exponent[lane]),
                                  large[place].singular, 1);
        terms.length =
            unless_large(std::ldexp(terms.length, batch.exponent[lane]), large[place].length, 1);
      });
}

template <int D>
void Contributions<D>::measure(std::span<const std::uint32_t> edges, std::span<EdgeTerm> out,
                               std::span<LargeTerms> large) const {
  if constexpr (D == 3) {
    const Source<D> source{filtration_->triangulation().sites(), is_wide_, unit_exponent_};
    const std::uint32_t first = filtration_->table().first(1);
    std::array<Vertices<2>, kLanes> vertices{};
    Batch<D, 2> batch{};
    Row lengths;
    in_batches(
        edges, [](std::uint32_t, unsigned) {},
        [&](std::uint32_t edge, std::size_t lane) {
          vertices[lane] = face_vertices<2>(*filtration_, SimplexId(first + edge));
        },
        [&](std::size_t lanes) { source.measure(vertices, lanes, nullptr, batch, lengths); },
        [&](std::size_t lane, std::size_t place) {
          out[place] = lengths[lane];
          if (!is_wide_) return;
          large[place] = {};
          out[place] =
              unless_large(std::ldexp(out[place], batch.exponent[lane]), large[place].length, 1);
        });
  }
}

template class Contributions<2>;
template class Contributions<3>;

}  // namespace orthoball
