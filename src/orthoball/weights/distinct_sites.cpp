// SPDX-License-Identifier: MIT
#include "orthoball/weights/distinct_sites.h"

#include <algorithm>
#include <cmath>

#include "orthoball/vectors.h"

namespace orthoball {

template <int D>
DistinctSites<D>::DistinctSites(const WeightedPoints& points) {
  struct Placed {
    std::array<double, std::size_t{D}> x;
    double weight;  // as in the array: a radius if it is one
    double low;
    std::uint32_t row;
    bool operator<(const Placed& other) const {
      if (x != other.x) return x < other.x;
      if (weight != other.weight) return weight < other.weight;
      return low != other.low ? low < other.low : row < other.row;
    }
  };
  std::vector<Placed> placed(points.size());
  for (std::size_t row = 0; row < placed.size(); ++row) {
    Placed& one = placed[row];
    for (std::size_t axis = 0; axis < D; ++axis) one.x[axis] = points.coordinates()[D * row + axis];
    one.weight = points.weights().empty() ? 0.0 : points.weights()[row];
    one.low = points.weights_low().empty() ? 0.0 : points.weights_low()[row];
    one.row = static_cast<std::uint32_t>(row);
  }
  std::sort(placed.begin(), placed.end());
  site_of_row.resize(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Placed& one = placed[i];
    const bool is_duplicate = i > 0 && placed[i - 1].x == one.x &&
                              placed[i - 1].weight == one.weight && placed[i - 1].low == one.low;
    if (!is_duplicate) {
      x.push_back(one.x);
      weight.push_back(points.weight_kind() == WeightKind::radius
                           ? one.weight * std::abs(one.weight)
                           : one.weight);
    }
    site_of_row[one.row] = static_cast<std::uint32_t>(x.size() - 1);
  }
}

template <int D>
double DistinctSites<D>::square_diameter(std::span<const std::uint32_t> some) const {
  double square = 0.0;
  for (const std::uint32_t a : some) {
    for (const std::uint32_t b : some) {
      const auto along = difference(x[a], x[b]);
      square = std::max(square, inner(along, along));
    }
  }
  return square;
}

template struct DistinctSites<2>;
template struct DistinctSites<3>;

}  // namespace orthoball
