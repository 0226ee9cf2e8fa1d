// SPDX-License-Identifier: MIT
// CGAL's side of a comparison, see case.h. `signatures` is the nearest that it has: Alpha_shape
// with exact comparison of alpha values and its filtration output.
#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Object.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "benchmarks/case.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using orthoball::WeightedPoints;
using orthoball::WeightKind;
using orthoball::benchmarks::Case;
using orthoball::benchmarks::Stopwatch;

// Numbers as our library takes them: integers in units of 10^-decimals where they are decimals.
double weight(const WeightedPoints& points, std::size_t row) {
  const double number = points.weights()[row];
  return points.weight_kind() == WeightKind::radius ? number * std::abs(number) : number;
}

std::vector<Kernel::Point_3> centres_3(const WeightedPoints& points) {
  std::vector<Kernel::Point_3> centres;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double* x = points.coordinates().data() + 3 * row;
    centres.emplace_back(x[0], x[1], x[2]);
  }
  return centres;
}

std::vector<Kernel::Point_2> centres_2(const WeightedPoints& points) {
  std::vector<Kernel::Point_2> centres;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double* x = points.coordinates().data() + 2 * row;
    centres.emplace_back(x[0], x[1]);
  }
  return centres;
}

template <class WeightedPoint, class Point>
std::vector<WeightedPoint> balls(const std::vector<Point>& centres, const WeightedPoints& points) {
  std::vector<WeightedPoint> result;
  for (std::size_t row = 0; row < centres.size(); ++row) {
    result.emplace_back(centres[row], weight(points, row));
  }
  return result;
}

// Seconds and number of finite cells of one triangulation.
template <class Triangulation, class Sites>
std::pair<double, std::size_t> triangulated(const Sites& sites) {
  const Stopwatch watch;
  const Triangulation triangulation(sites.begin(), sites.end());
  const double seconds = watch.seconds();
  if constexpr (std::is_same_v<typename Triangulation::Point, Kernel::Point_2> ||
                std::is_same_v<typename Triangulation::Point, Kernel::Weighted_point_2>) {
    return {seconds, triangulation.number_of_faces()};
  } else {
    return {seconds, triangulation.number_of_finite_cells()};
  }
}

std::pair<double, std::size_t> triangulation(const WeightedPoints& points) {
  const bool weighted = points.weight_kind() != WeightKind::none;
  if (points.dimension() == 2) {
    const auto centres = centres_2(points);
    if (!weighted) return triangulated<CGAL::Delaunay_triangulation_2<Kernel>>(centres);
    return triangulated<CGAL::Regular_triangulation_2<Kernel>>(
        balls<Kernel::Weighted_point_2>(centres, points));
  }
  const auto centres = centres_3(points);
  if (!weighted) return triangulated<CGAL::Delaunay_triangulation_3<Kernel>>(centres);
  return triangulated<CGAL::Regular_triangulation_3<Kernel>>(
      balls<Kernel::Weighted_point_3>(centres, points));
}

std::pair<double, std::size_t> filtration(const WeightedPoints& points) {
  if (points.dimension() != 3 || points.weight_kind() != WeightKind::none) {
    throw std::invalid_argument("the peer of `signatures` takes points of space without weights");
  }
  using Exact = CGAL::Tag_true;
  using Vertex = CGAL::Alpha_shape_vertex_base_3<Kernel, CGAL::Default, Exact>;
  using Cell = CGAL::Alpha_shape_cell_base_3<Kernel, CGAL::Default, Exact>;
  using Structure = CGAL::Triangulation_data_structure_3<Vertex, Cell>;
  using Shape = CGAL::Alpha_shape_3<CGAL::Delaunay_triangulation_3<Kernel, Structure>, Exact>;

  const auto centres = centres_3(points);
  const Stopwatch watch;
  const Shape shape(centres.begin(), centres.end());
  std::vector<CGAL::Object> simplices;
  std::vector<Shape::FT> values;
  shape.filtration_with_alpha_values(CGAL::dispatch_output<CGAL::Object, Shape::FT>(
      std::back_inserter(simplices), std::back_inserter(values)));
  return {watch.seconds(), simplices.size()};
}

}  // namespace

int main(int argc, char** argv) {
  const Case task = orthoball::benchmarks::case_of(argc, argv);
  const auto [seconds, count] =
      task.work == "triangulation" ? triangulation(task.points) : filtration(task.points);
  orthoball::benchmarks::report(seconds, count);
}
