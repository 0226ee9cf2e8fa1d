// SPDX-License-Identifier: MIT
//
// Boxes are cut in two again and again, as in a k-d tree. Of all planes near the middle that one is
// taken which has the fewest sites near by: whose neighbours on both sides, a few sites away, are
// the farthest from each other.
#include "orthoball/triangulation/territory_boxes.h"

#include <algorithm>

namespace orthoball {
namespace {

constexpr std::size_t kSampleOfBox = 64;

struct Plane {
  std::size_t axis = 0;
  double at = 0.0;
  double gap = -1.0;  // around it
};

// The best of those across one axis.
Plane best_plane(std::size_t axis, std::vector<double>& x, std::size_t middle) {
  std::sort(x.begin(), x.end());
  const std::size_t reach = x.size() / 12, near = x.size() / 32;
  Plane best;
  for (std::size_t i = middle - reach; i <= middle + reach; ++i) {
    const double gap = x[i + near] - x[i - near];
    if (gap > best.gap) best = {axis, x[i - near] + 0.5 * gap, gap};
  }
  return best;
}

template <int D>
void cut(const Box<D>& box, std::span<Site<D>> sample, std::size_t count,
         std::vector<Box<D>>& boxes) {
  if (count == 1 || sample.size() < kSampleOfBox) {
    boxes.push_back(box);
    return;
  }
  const std::size_t below = count / 2;
  Plane plane;
  std::vector<double> x(sample.size());
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (std::size_t i = 0; i < sample.size(); ++i) x[i] = sample[i].x[axis];
    const Plane best = best_plane(axis, x, sample.size() * below / count);
    if (best.gap > plane.gap) plane = best;
  }
  Box<D> low = box, high = box;
  low.high[plane.axis] = high.low[plane.axis] = plane.at;
  const auto middle = std::partition(sample.begin(), sample.end(), [&](const Site<D>& site) {
    return site.x[plane.axis] < plane.at;
  });
  const auto size = static_cast<std::size_t>(middle - sample.begin());
  cut(low, sample.first(size), below, boxes);
  cut(high, sample.subspan(size), count - below, boxes);
}

}  // namespace

template <int D>
std::vector<Box<D>> territory_boxes(const Sites<D>& all, std::span<const std::uint32_t> sites,
                                    std::size_t count) {
  std::vector<Site<D>> sample;
  const std::size_t step = sites.size() / (kSampleOfBox * count) + 1;
  for (std::size_t i = 0; i < sites.size(); i += step) sample.push_back(all[sites[i]]);
  std::vector<Box<D>> boxes;
  cut(Box<D>::whole(), std::span<Site<D>>(sample), count, boxes);
  return boxes;
}

template std::vector<Box<2>> territory_boxes<2>(const Sites<2>&, std::span<const std::uint32_t>,
                                                std::size_t);
template std::vector<Box<3>> territory_boxes<3>(const Sites<3>&, std::span<const std::uint32_t>,
                                                std::size_t);

}  // namespace orthoball
