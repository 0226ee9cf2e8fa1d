// SPDX-License-Identifier: MIT
//
// Every site draws a number made of its coordinates, its weight and the seed; those with the
// smallest are taken. Equal sites draw the same number: of these the lowest rows are taken.
#include "orthoball/points/subsample.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "orthoball/error.h"

namespace orthoball {
namespace {

// All bits of a number depend on all bits of the result: the finalizer of MurmurHash3.
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 33U)) * 0xFF51AFD7ED558CCDU;
  bits = (bits ^ (bits >> 33U)) * 0xC4CEB9FE1A85EC53U;
  return bits ^ (bits >> 33U);
}

std::uint64_t with(std::uint64_t drawn, double number) {
  return mixed(drawn + 0x9E3779B97F4A7C15U + std::bit_cast<std::uint64_t>(number + 0.0));
}

}  // namespace

WeightedPoints subsample(const WeightedPoints& points, double share, std::uint64_t seed) {
  if (!(share > 0.0 && share <= 1.0)) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "the share of a subsample must be above 0 and at most 1");
  }
  const auto dimension = static_cast<std::size_t>(points.dimension());
  const auto of_row = [&](std::size_t row, std::size_t axis) {
    return points.coordinates()[dimension * row + axis];
  };
  std::vector<std::pair<std::uint64_t, std::size_t>> drawn(points.size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    std::uint64_t number = mixed(seed);
    for (std::size_t axis = 0; axis < dimension; ++axis) number = with(number, of_row(row, axis));
    if (!points.weights().empty()) number = with(number, points.weights()[row]);
    if (!points.weights_low().empty()) number = with(number, points.weights_low()[row]);
    drawn[row] = {number, row};
  }
  const auto count =
      static_cast<std::size_t>(std::ceil(share * static_cast<double>(points.size())));
  std::sort(drawn.begin(), drawn.end());
  drawn.resize(std::min(count, drawn.size()));
  std::sort(drawn.begin(), drawn.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });

  std::vector<double> coordinates, weights, weights_low;
  for (const auto& [number, row] : drawn) {
    for (std::size_t axis = 0; axis < dimension; ++axis) coordinates.push_back(of_row(row, axis));
    if (!points.weights().empty()) weights.push_back(points.weights()[row]);
    if (!points.weights_low().empty()) weights_low.push_back(points.weights_low()[row]);
  }
  if (!points.decimals()) {
    return {points.dimension(), std::move(coordinates), points.weight_kind(), std::move(weights)};
  }
  return WeightedPoints::fixed_point(points.dimension(), *points.decimals(), std::move(coordinates),
                                     points.weight_kind(), std::move(weights),
                                     std::move(weights_low));
}

}  // namespace orthoball
