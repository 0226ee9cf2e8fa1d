// SPDX-License-Identifier: MIT
#include "orthoball/output/filter_lines.h"

#include <algorithm>

#include "orthoball/filtration/face_vertices.h"

namespace orthoball {
namespace {

// The vertices of a simplex whose dimension is known, in any order.
template <int Dimension, int D>
std::array<std::uint32_t, std::size_t{Dimension} + 1> vertices_of(const Filtration<D>& filtration,
                                                                  SimplexId simplex) {
  if constexpr (Dimension == 0) {
    return {simplex.row()};
  } else if constexpr (Dimension < D) {
    return face_vertices<std::size_t{Dimension} + 1>(filtration, simplex);
  } else {
    const auto cells = filtration.triangulation().template cells<D>();
    return cells[simplex.row() - filtration.table().first(D)].corners;
  }
}

}  // namespace

template <int D>
template <int Dimension>
void FilterLines<D>::gather(std::span<const SimplexId> simplices) {
  const std::vector<std::uint32_t>& places = places_[Dimension];
  const Sites<D>& sites = filtration_.triangulation().sites();
  for (const std::uint32_t place : places) {
    const auto vertices = vertices_of<Dimension>(filtration_, simplices[place]);
    std::copy(vertices.begin(), vertices.end(), lines_[place].rows.begin());
  }
  for (const std::uint32_t place : places) {
    auto& rows = lines_[place].rows;
    for (std::size_t i = 0; i <= Dimension; ++i) rows[i] = sites.row(rows[i]).row();
  }
  for (const std::uint32_t place : places) {
    FilterLine<D>& line = lines_[place];
    line.dimension = Dimension;
    line.enters = filtration_.enters(simplices[place]);
    line.regular = filtration_.regular(simplices[place]);
    line.interior = filtration_.interior(simplices[place]);
    std::sort(line.rows.begin(), line.rows.begin() + Dimension + 1);
  }
}

template <int D>
std::span<const FilterLine<D>> FilterLines<D>::lines(std::span<const SimplexId> simplices) {
  for (auto& places : places_) places.clear();
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    const auto dimension = static_cast<std::size_t>(filtration_.dimension(simplices[i]));
    places_[dimension].push_back(static_cast<std::uint32_t>(i));
  }
  gather<0>(simplices);
  gather<1>(simplices);
  gather<2>(simplices);
  if constexpr (D == 3) gather<3>(simplices);
  return std::span(lines_).first(simplices.size());
}

template class FilterLines<2>;
template class FilterLines<3>;

}  // namespace orthoball
