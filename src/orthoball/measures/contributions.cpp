// SPDX-License-Identifier: MIT
//
// Simplices are measured in batches: the coordinates of kLanes of them are laid out side by side,
// and every formula is a loop over the lanes without branches, which compilers turn into vector
// code.
//
// A tetrahedron with vertices a, b, c, d gives the cross products n_a, n_b, n_c, n_d of its facets
// (n_a without a, and so on), each a product of differences from the facet's first vertex, so that
// the same facet gives the same double from both sides. The angle at an edge between the outward
// normals of its two facets, the exterior angle, has the cosine +-(n . m) / (|n| |m|) and the sine
// |n x m| / (|n| |m|). As n x m is 6 V times the edge, its length is 6 V len, and the angle is
// atan2(6 V len, +-(n . m)): the sign is the product of the signs that turn both outward. Where a
// cross product is all rounding the cell is measured again with integers (thin_cell.h).
#include "orthoball/measures/contributions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "orthoball/exact/processor.h"
#include "orthoball/filtration/face_vertices.h"
#include "orthoball/measures/angle.h"
#include "orthoball/measures/thin_cell.h"

namespace orthoball {
namespace {

constexpr std::size_t kLanes = 32;

struct alignas(64) Row : std::array<double, kLanes> {};

template <int D>
using Points = std::array<Row, static_cast<std::size_t>(D)>;  // [axis][lane]

// N points per lane and the exponent of its results: lengths are to be multiplied by 2^exponent,
// areas by 2^(2 exponent) and so on.
template <int D, std::size_t N>
struct Batch {
  std::array<Points<D>, N> x;
  std::array<int, kLanes> exponent;
};

struct Vector {
  double x, y, z;
};
[[gnu::always_inline]] inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline double norm(const Vector& a) { return std::sqrt(dot(a, a)); }
[[gnu::always_inline]] inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[gnu::always_inline]] inline Vector vector(const Points<3>& points, std::size_t lane) {
  return {points[0][lane], points[1][lane], points[2][lane]};
}
[[gnu::always_inline]] inline double length(const Points<2>& a, const Points<2>& b,
                                            std::size_t lane) {
  const double x = b[0][lane] - a[0][lane], y = b[1][lane] - a[1][lane];
  return std::sqrt(x * x + y * y);
}

// What the kernels give, lane by lane.
template <int D>
struct CellRows {
  Row volume, length;
  Row excess;  // negative where a facet is thin: see thin_cell.h
  std::array<Row, kCorners<D>> facets;
};
struct FacetRows {
  Row area, perimeter;
};

[[gnu::always_inline]] inline void measure_lanes(const Batch<3, 4>& __restrict batch,
                                                 CellRows<3>& __restrict out) {
  alignas(64) std::array<Row, 6> lengths, cosines;
  for (std::size_t k = 0; k < kLanes; ++k) {
    const Vector a = vector(batch.x[0], k), b = vector(batch.x[1], k);
    const Vector c = vector(batch.x[2], k), d = vector(batch.x[3], k);
    const Vector ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b;
    const Vector n_d = cross(ab, ac), n_c = cross(ab, ad), n_b = cross(ac, ad), n_a = cross(bc, bd);
    out.volume[k] = std::abs(dot(ab, n_b));
    out.facets[0][k] = norm(n_a);
    out.facets[1][k] = norm(n_b);
    out.facets[2][k] = norm(n_c);
    out.facets[3][k] = norm(n_d);
    lengths[0][k] = norm(ab);
    lengths[1][k] = norm(ac);
    lengths[2][k] = norm(ad);
    lengths[3][k] = norm(bc);
    lengths[4][k] = norm(bd);
    lengths[5][k] = norm(d - c);
    // n_a and n_c point outward where n_b and n_d point inward, or the other way round.
    cosines[0][k] = -dot(n_c, n_d);
    cosines[1][k] = dot(n_b, n_d);
    cosines[2][k] = -dot(n_b, n_c);
    cosines[3][k] = -dot(n_a, n_d);
    cosines[4][k] = dot(n_a, n_c);
    cosines[5][k] = -dot(n_a, n_b);
  }
  // How far the facets are from thin: negative where one is.
  for (std::size_t k = 0; k < kLanes; ++k) {
    out.excess[k] = std::min(std::min(out.facets[0][k] - kThin * lengths[3][k] * lengths[4][k],
                                      out.facets[1][k] - kThin * lengths[1][k] * lengths[2][k]),
                             std::min(out.facets[2][k] - kThin * lengths[0][k] * lengths[2][k],
                                      out.facets[3][k] - kThin * lengths[0][k] * lengths[1][k]));
  }
  out.length.fill(0.0);
  for (std::size_t edge = 0; edge < 6; ++edge) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double sine = out.volume[k] * lengths[edge][k];
      out.length[k] += lengths[edge][k] * angle_from_x_axis(cosines[edge][k], sine);
    }
  }
}

[[gnu::always_inline]] inline void measure_lanes(const Batch<2, 3>& __restrict batch,
                                                 CellRows<2>& __restrict out) {
  const auto& [a, b, c] = batch.x;
  for (std::size_t k = 0; k < kLanes; ++k) {
    out.volume[k] = std::abs((b[0][k] - a[0][k]) * (c[1][k] - a[1][k]) -
                             (b[1][k] - a[1][k]) * (c[0][k] - a[0][k]));
    out.facets[0][k] = length(b, c, k);
    out.facets[1][k] = length(a, c, k);
    out.facets[2][k] = length(a, b, k);
  }
  out.length.fill(0.0);
  out.excess.fill(0.0);
}

[[gnu::always_inline]] inline void measure_lanes(const Batch<3, 3>& __restrict batch,
                                                 FacetRows& __restrict out) {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const Vector a = vector(batch.x[0], k), b = vector(batch.x[1], k), c = vector(batch.x[2], k);
    const Vector ab = b - a, ac = c - a;
    out.area[k] = norm(cross(ab, ac));
    out.perimeter[k] = norm(ab) + norm(ac) + norm(c - b);
  }
}

[[gnu::always_inline]] inline void measure_lanes(const Batch<2, 2>& __restrict batch,
                                                 FacetRows& __restrict out) {
  for (std::size_t k = 0; k < kLanes; ++k) out.area[k] = length(batch.x[0], batch.x[1], k);
  out.perimeter.fill(0.0);
}

[[gnu::always_inline]] inline void measure_lanes(const Batch<3, 2>& __restrict batch,
                                                 Row& __restrict out) {
  for (std::size_t k = 0; k < kLanes; ++k) {
    out[k] = norm(vector(batch.x[1], k) - vector(batch.x[0], k));
  }
}

// The same bits with wider vectors, where the machine has them: no operation is fused with another.
template <int D, std::size_t N, class Rows>
ORTHOBALL_AVX2 void measure_wide(const Batch<D, N>& __restrict batch, Rows& __restrict out) {
  measure_lanes(batch, out);
}

template <int D, std::size_t N, class Rows>
void measure(const Batch<D, N>& batch, Rows& out) {
  has_avx2() ? measure_wide(batch, out) : measure_lanes(batch, out);
}

template <std::size_t N>
using Vertices = std::array<std::uint32_t, N>;  // by number, ascending

// Where the coordinates come from and in which unit contributions are wanted.
template <int D>
struct Source {
  const Sites<D>& sites;
  bool is_wide;
  int unit_exponent;

  template <std::size_t N>
  void load(const Vertices<N>& vertices, std::size_t lane, Batch<D, N>& batch) const {
    if (is_wide) {
      load_wide(vertices, lane, batch);
      return;
    }
    batch.exponent[lane] = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const Site<D>& site = sites[vertices[i]];
      for (std::size_t axis = 0; axis < D; ++axis) batch.x[i][axis][lane] = site.x[axis];
    }
  }

 private:
  // The simplex moved to the origin and scaled by a power of two to a size between 1/2 and 1.
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
// approach(simplex, step) takes one more step, 0 to 2, to bringing what a simplex is made of nearer
// to the processor, load(simplex, lane) fills a lane, store(lane, place) writes one out.
template <class Approach, class Load, class Measure, class Store>
void in_batches(std::span<const std::uint32_t> simplices, const Approach& approach,
                const Load& load, const Measure& measure_lanes, const Store& store) {
  const std::size_t size = simplices.size();
  const auto approach_from = [&](std::size_t begin, unsigned step) __attribute__((always_inline)) {
    const std::size_t end = std::min(begin + kLanes, size);
    for (std::size_t i = begin; i < end; ++i) approach(simplices[i], step);
  };
  for (std::size_t begin = 0; begin < size; begin += kLanes) {
    const std::size_t lanes = std::min(kLanes, size - begin);
    approach_from(begin + 3 * kLanes, 0);
    approach_from(begin + 2 * kLanes, 1);
    approach_from(begin + kLanes, 2);
    for (std::size_t lane = 0; lane < lanes; ++lane) load(simplices[begin + lane], lane);
    measure_lanes();
    for (std::size_t lane = 0; lane < lanes; ++lane) store(lane, begin + lane);
  }
}

// The steps of in_batches to the sites of a face, where owners[face] is kPlaces * cell + a place.
template <int D, std::uint32_t kPlaces>
class FaceApproach {
 public:
  FaceApproach(const Filtration<D>& filtration, int dimension,
               std::span<const std::uint32_t> owners)
      : cells_(filtration.triangulation().template cells<D>()),
        sites_(filtration.triangulation().sites().span()),
        first_(filtration.table().first(dimension)),
        owners_(owners) {}

  [[gnu::always_inline]] void operator()(std::uint32_t face, unsigned step) const {
    if (cells_.empty()) return;
    const std::uint32_t& owner = owners_[face - first_];
    if (step == 0) return __builtin_prefetch(&owner);
    const CellRecord<D>& record = cells_[owner / kPlaces];
    if (step == 1) return __builtin_prefetch(&record);
    for (const std::uint32_t corner : record.corners) __builtin_prefetch(&sites_[corner]);
  }

 private:
  std::span<const CellRecord<D>> cells_;
  std::span<const Site<D>> sites_;
  std::uint32_t first_;
  std::span<const std::uint32_t> owners_;
};

// The areas of a cell's facets as the facets themselves give them, each in its own scale: in the
// cell's scale a small one may vanish.
template <int D>
void measure_facets_alone(const Source<D>& source, const Vertices<kCorners<D>>& vertices,
                          CellContribution<D>& cell) {
  Batch<D, kCorners<D> - 1> batch{};
  FacetRows rows;
  for (std::size_t i = 0; i < kCorners<D>; ++i) {
    Vertices<kCorners<D> - 1> facet{};
    for (std::size_t j = 0; j < facet.size(); ++j) facet[j] = vertices[j < i ? j : j + 1];
    source.load(facet, i, batch);
  }
  measure(batch, rows);
  for (std::size_t i = 0; i < kCorners<D>; ++i) {
    cell.facets[i] = std::ldexp(rows.area[i], (D - 1) * batch.exponent[i]);
  }
}

}  // namespace

template <int D>
Contributions<D>::Contributions(const Filtration<D>& filtration)
    : filtration_(&filtration),
      unit_exponent_(filtration.triangulation().sites().scale_exponent()) {}

template <int D>
Contributions<D>::Contributions(const Filtration<D>& filtration, int unit_exponent)
    : filtration_(&filtration), is_wide_(true), unit_exponent_(unit_exponent) {}

template <int D>
void Contributions<D>::measure(std::span<const std::uint32_t> cells,
                               std::span<CellContribution<D>> out) const {
  const RegularTriangulation<D>& triangulation = filtration_->triangulation();
  const Source<D> source{triangulation.sites(), is_wide_, unit_exponent_};
  const auto records = triangulation.template cells<D>();
  const std::uint32_t first = filtration_->table().first(D);
  const std::span<const std::uint32_t> enters = filtration_->enters().subspan(first);
  Batch<D, kCorners<D>> batch{};
  CellRows<D> rows;
  std::array<Vertices<kCorners<D>>, kLanes> vertices;
  // [lane][corner]: the sign of the facet opposite.
  std::array<std::array<std::uint64_t, kCorners<D>>, kLanes> signs;
  constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63U;

  const auto approach = [&](std::uint32_t simplex, unsigned step) __attribute__((always_inline)) {
    const std::uint32_t cell = simplex - first;
    const CellRecord<D>& record = records[cell];
    if (step == 0) return __builtin_prefetch(&record);
    if (step == 1) {
      __builtin_prefetch(&enters[cell]);
      for (const std::uint32_t beyond : record.neighbours) {
        if (beyond != kOutside) __builtin_prefetch(&enters[beyond / 4]);
      }
      return;
    }
    for (const std::uint32_t corner : record.corners) __builtin_prefetch(&source.sites[corner]);
  };
  const auto load = [&](std::uint32_t simplex, std::size_t lane) {
    const std::uint32_t cell = simplex - first;
    const CellRecord<D>& record = records[cell];
    const auto place_in_filter = [&](std::uint32_t of) {
      return std::uint64_t{enters[of]} << 32U | of;
    };
    const std::uint64_t own = place_in_filter(cell);
    for (std::size_t corner = 0; corner < kCorners<D>; ++corner) {
      const std::uint32_t beyond = record.neighbours[corner];
      signs[lane][corner] =
          place_in_filter(beyond == kOutside ? cell : beyond / 4) < own ? kSignBit : 0;
    }
    // Corners ascend but for the last two.
    vertices[lane] = record.corners;
    const bool descend = vertices[lane][D] < vertices[lane][D - 1];
    vertices[lane][D - 1] = std::min(record.corners[D - 1], record.corners[D]);
    vertices[lane][D] = std::max(record.corners[D - 1], record.corners[D]);
    const std::array last{signs[lane][D - 1], signs[lane][D]};
    signs[lane][D - 1] = last[descend ? 1 : 0];
    signs[lane][D] = last[descend ? 0 : 1];
    source.load(vertices[lane], lane, batch);
  };
  const auto store = [&](std::size_t lane, std::size_t place) {
    CellContribution<D>& cell = out[place];
    cell.volume = rows.volume[lane];
    cell.length = rows.length[lane];
    for (std::size_t i = 0; i < kCorners<D>; ++i) cell.facets[i] = rows.facets[i][lane];
    if (is_wide_) {
      cell.volume = std::ldexp(cell.volume, D * batch.exponent[lane]);
      measure_facets_alone(source, vertices[lane], cell);
    }
    if constexpr (D == 3) {
      if (is_wide_ || rows.excess[lane] < 0.0) {
        const ThinCell thin = thin_cell(source.sites, vertices[lane],
                                        source.sites.exact_scale_exponent() - unit_exponent_);
        cell.volume = thin.volume;
        cell.length = thin.length;
      }
    }
    for (std::size_t i = 0; i < kCorners<D>; ++i) {
      const auto area = std::bit_cast<std::uint64_t>(cell.facets[i]);
      cell.facets[i] = std::bit_cast<double>(area ^ signs[lane][i]);
    }
  };
  in_batches(
      cells, approach, load, [&] { orthoball::measure(batch, rows); }, store);
}

template <int D>
void Contributions<D>::measure(std::span<const std::uint32_t> facets,
                               std::span<FacetContribution> out) const {
  const Source<D> source{filtration_->triangulation().sites(), is_wide_, unit_exponent_};
  Batch<D, kCorners<D> - 1> batch{};
  FacetRows rows;
  in_batches(
      facets, FaceApproach<D, 4>(*filtration_, D - 1, filtration_->table().facet_owners()),
      [&](std::uint32_t simplex, std::size_t lane) {
        source.load(face_vertices<kCorners<D> - 1>(*filtration_, SimplexId(simplex)), lane, batch);
      },
      [&] { orthoball::measure(batch, rows); },
      [&](std::size_t lane, std::size_t place) {
        out[place] = {rows.area[lane], rows.perimeter[lane]};
        if (!is_wide_) return;
        out[place].area = std::ldexp(out[place].area, (D - 1) * batch.exponent[lane]);
        out[place].perimeter = std::ldexp(out[place].perimeter, batch.exponent[lane]);
      });
}

template <int D>
void Contributions<D>::measure(std::span<const std::uint32_t> edges,
                               std::span<EdgeContribution> out) const {
  if constexpr (D == 3) {
    const Source<D> source{filtration_->triangulation().sites(), is_wide_, unit_exponent_};
    Batch<D, 2> batch{};
    Row lengths;
    in_batches(
        edges, FaceApproach<D, 6>(*filtration_, 1, filtration_->table().edge_owners()),
        [&](std::uint32_t simplex, std::size_t lane) {
          source.load(face_vertices<2>(*filtration_, SimplexId(simplex)), lane, batch);
        },
        [&] { orthoball::measure(batch, lengths); },
        [&](std::size_t lane, std::size_t place) {
          out[place] = is_wide_ ? std::ldexp(lengths[lane], batch.exponent[lane]) : lengths[lane];
        });
  }
}

template class Contributions<2>;
template class Contributions<3>;

}  // namespace orthoball
