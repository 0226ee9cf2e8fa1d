// SPDX-License-Identifier: MIT
//
// Half the mean square distance to the nearest others, site by site from a k-d tree.
//
// Why the mean of squares: the squared distance to one site is |x|^2 and an affine function of x,
// so the sum over the K + 1 nearest sites of x, the least of all sums over K + 1 sites, is
// (K + 1) |x|^2 less a convex function. At a site it is d_1^2 + ... + d_K^2, the site itself having
// distance 0. Hence |x|^2 - w(x) = (1 - (K + 1) / (2 K)) |x|^2 + a convex function: convex, and
// strictly so for K > 1. Lifted sites on the graph of a convex function are all on its lower hull,
// which is what not being hidden means. Up to a factor w is the squared distance to the measure of
// the sites.
//
// Chazal, Cohen-Steiner, Merigot. Geometric inference for probability measures. Foundations of
// Computational Mathematics 11 (2011).
#include "orthoball/points/density_weights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "orthoball/counted.h"
#include "orthoball/error.h"
#include "orthoball/points/position_tree.h"

namespace orthoball {
namespace {

constexpr double kLargestInteger = 9007199254740992.0;  // 2^53, of coordinates
constexpr double kLargestWeight = kLargestInteger * kLargestInteger;
constexpr int kMoreDecimals = 2;

[[noreturn]] void refuse(const std::string& message) {
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow, message);
}

// [row]: 2 K times the weights, in the unit of the arrays squared.
template <int D>
std::vector<double> sums_of_squares(const WeightedPoints& points, std::size_t neighbours,
                                    Threads threads) {
  const PositionTree<D> tree(points, threads);
  if (neighbours >= tree.size()) {
    refuse(
        fmt::format("the {} asked for, and there {} {} at different positions; there must be more "
                    "than neighbours",
                    neighbours == 1 ? "nearest neighbour is"
                                    : fmt::format("{} nearest neighbours are", neighbours),
                    tree.size() == 1 ? "is" : "are", counted(tree.size(), "site")));
  }
  std::vector<double> sums(tree.size());  // [position]
  constexpr std::size_t kLeast = 1024;    // positions that are worth a thread
  const Threads used = threads.for_work(tree.size(), kLeast);
  parallel_parts(used, tree.size(), std::size_t{16} * used.count(),
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   std::vector<double> squares(neighbours);
                   for (std::size_t at = begin; at < end; ++at) {
                     tree.nearest_squares(static_cast<std::uint32_t>(at), squares);
                     sums[at] = std::accumulate(squares.begin(), squares.end(), 0.0);
                   }
                 });
  std::vector<double> of_rows;
  of_rows.reserve(points.size());
  for (const std::uint32_t position : tree.position_of_row()) of_rows.push_back(sums[position]);
  return of_rows;
}

// Empty where the weights or the coordinates in their unit are beyond what is held exactly.
std::optional<WeightedPoints> as_decimals(const WeightedPoints& points,
                                          const std::vector<double>& sums, double divisor) {
  if (!points.decimals()) return std::nullopt;
  double largest = 0.0;
  for (const double x : points.coordinates()) largest = std::max(largest, std::abs(x));
  int more = kMoreDecimals;
  while (more > 0 && largest * std::pow(10.0, more) > kLargestInteger) --more;
  const double factor = std::pow(10.0, more);
  std::vector<double> coordinates(points.coordinates().begin(), points.coordinates().end());
  for (double& x : coordinates) x *= factor;
  std::vector<double> weights;
  weights.reserve(sums.size());
  for (const double sum : sums) {
    weights.push_back(std::nearbyint(sum * (factor * factor) / divisor));
    if (weights.back() > kLargestWeight) return std::nullopt;
  }
  const int decimals = *points.decimals() + more;
  constexpr int kMostDecimals = 400;
  if (decimals > kMostDecimals) return std::nullopt;
  return WeightedPoints::fixed_point(points.dimension(), decimals, std::move(coordinates),
                                     WeightKind::weight, std::move(weights));
}

WeightedPoints as_doubles(const WeightedPoints& points, std::vector<double> sums, double divisor) {
  const double unit = std::pow(10.0, -points.decimals().value_or(0));
  for (std::size_t row = 0; row < sums.size(); ++row) {
    sums[row] = sums[row] / divisor * unit * unit;
    if (std::isfinite(sums[row]) && sums[row] >= std::numeric_limits<double>::min()) continue;
    throw InputError(
        InputError::Reason::not_finite, row,
        fmt::format("row {}: the squared distances to its neighbours are beyond the range of "
                    "doubles; coordinates must be given in another unit",
                    row));
  }
  std::vector<double> coordinates;
  coordinates.reserve(points.coordinates().size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (int axis = 0; axis < points.dimension(); ++axis) {
      coordinates.push_back(points.coordinate(row, axis));
    }
  }
  return {points.dimension(), std::move(coordinates), WeightKind::weight, std::move(sums)};
}

}  // namespace

WeightedPoints with_density_weights(const WeightedPoints& points, std::size_t neighbours,
                                    Threads threads) {
  if (neighbours == 0) refuse("0 nearest neighbours are asked for; there must be 1 or more");
  if (points.size() == 0) return points;
  std::vector<double> sums = points.dimension() == 2
                                 ? sums_of_squares<2>(points, neighbours, threads)
                                 : sums_of_squares<3>(points, neighbours, threads);
  const double divisor = 2.0 * static_cast<double>(neighbours);
  if (auto exact = as_decimals(points, sums, divisor)) return *std::move(exact);
  return as_doubles(points, std::move(sums), divisor);
}

std::size_t density_weights_memory(int dimension, std::size_t sites) {
  // The positions twice while they are arranged, with their numbers; the sums.
  return sites * (std::size_t{16} * static_cast<std::size_t>(dimension) + 40);
}

}  // namespace orthoball
