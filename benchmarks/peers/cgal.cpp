// SPDX-License-Identifier: MIT
// CGAL's side of a comparison, see case.h. `filtration` is the nearest that it has: in space
// Alpha_shape_3 with exact comparison of alpha values and the output of its filtration; in the
// plane Alpha_shape_2 as it comes, which compares doubles, and with exact comparison as
// `exact_filtration`.
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

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "benchmarks/case.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using orthoball::WeightedPoints;
using orthoball::WeightKind;
using orthoball::benchmarks::Case;
using orthoball::benchmarks::Meter;

// Numbers as our library takes them: integers in units of 10^-decimals where they are decimals.
template <class Point>
std::vector<Point> sites(const WeightedPoints& points) {
  std::vector<Point> result;
  result.reserve(points.size());
  const double* x = points.coordinates().data();
  for (std::size_t row = 0; row < points.size(); ++row, x += points.dimension()) {
    const double weight = orthoball::benchmarks::weight(points, row);
    if constexpr (std::is_same_v<Point, Kernel::Point_2>) {
      result.emplace_back(x[0], x[1]);
    } else if constexpr (std::is_same_v<Point, Kernel::Weighted_point_2>) {
      result.emplace_back(Kernel::Point_2(x[0], x[1]), weight);
    } else if constexpr (std::is_same_v<Point, Kernel::Point_3>) {
      result.emplace_back(x[0], x[1], x[2]);
    } else {
      result.emplace_back(Kernel::Point_3(x[0], x[1], x[2]), weight);
    }
  }
  return result;
}

template <class Triangulation>
void triangulate(const Case& task) {
  const auto points = sites<typename Triangulation::Point>(task.points);
  const Meter meter;
  const Triangulation triangulation(points.begin(), points.end());
  std::size_t cells = 0;
  if constexpr (std::is_same_v<typename Triangulation::Point, Kernel::Point_2> ||
                std::is_same_v<typename Triangulation::Point, Kernel::Weighted_point_2>) {
    cells = triangulation.number_of_faces();
  } else {
    cells = triangulation.number_of_finite_cells();
  }
  meter.report(task, {{"cells", cells}, {"vertices", triangulation.number_of_vertices()}});
}

template <class IsExact>
void filter_plane(const Case& task) {
  using Vertex = CGAL::Alpha_shape_vertex_base_2<Kernel, CGAL::Default, IsExact>;
  using Face = CGAL::Alpha_shape_face_base_2<Kernel, CGAL::Default, IsExact>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
  using Shape = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<Kernel, Structure>, IsExact>;

  const auto points = sites<Kernel::Point_2>(task.points);
  const Meter meter;
  const Shape shape(points.begin(), points.end(), 0, Shape::GENERAL);
  const std::size_t vertices = shape.number_of_vertices(), cells = shape.number_of_faces();
  // A triangulated disk has V + F - 1 edges.
  meter.report(task, {{"cells", cells}, {"simplices", 2 * (vertices + cells) - 1}});
}

void filter_space(const Case& task) {
  using Exact = CGAL::Tag_true;
  using Vertex = CGAL::Alpha_shape_vertex_base_3<Kernel, CGAL::Default, Exact>;
  using Cell = CGAL::Alpha_shape_cell_base_3<Kernel, CGAL::Default, Exact>;
  using Structure = CGAL::Triangulation_data_structure_3<Vertex, Cell>;
  using Shape = CGAL::Alpha_shape_3<CGAL::Delaunay_triangulation_3<Kernel, Structure>, Exact>;

  const auto points = sites<Kernel::Point_3>(task.points);
  const Meter meter;
  const Shape shape(points.begin(), points.end(), 0, Shape::GENERAL);
  std::vector<CGAL::Object> simplices;
  std::vector<Shape::FT> values;
  shape.filtration_with_alpha_values(CGAL::dispatch_output<CGAL::Object, Shape::FT>(
      std::back_inserter(simplices), std::back_inserter(values)));
  meter.report(task, {{"simplices", simplices.size()}});
}

}  // namespace

int main(int argc, char** argv) {
  const Case task = orthoball::benchmarks::case_of(argc, argv);
  const bool is_flat = task.points.dimension() == 2;
  const bool has_weights = task.points.weight_kind() != WeightKind::none;
  if (task.work == "triangulation") {
    if (is_flat && has_weights) triangulate<CGAL::Regular_triangulation_2<Kernel>>(task);
    if (is_flat && !has_weights) triangulate<CGAL::Delaunay_triangulation_2<Kernel>>(task);
    if (!is_flat && has_weights) triangulate<CGAL::Regular_triangulation_3<Kernel>>(task);
    if (!is_flat && !has_weights) triangulate<CGAL::Delaunay_triangulation_3<Kernel>>(task);
  } else if (task.work == "filtration" && !has_weights) {
    is_flat ? filter_plane<CGAL::Tag_false>(task) : filter_space(task);
  } else if (task.work == "exact_filtration" && is_flat && !has_weights) {
    filter_plane<CGAL::Tag_true>(task);
  } else {
    throw std::invalid_argument("not a work that CGAL is asked for");
  }
}
