// SPDX-License-Identifier: MIT
// Our indices, roles and labels beside CGAL's Alpha_shape_3 and Alpha_shape_2 with exact
// comparison. Where sites are degenerate the triangulations differ, but not the set of values: the
// faces that only a triangulation has take values of the polytopes that it cuts.
//
// Alpha_shape_2 keeps -1 and -2 for "never" and "attached", so it is asked of points without
// weights only; it calls a vertex singular by another definition, so its vertices are left out.
#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <span>

#include "orthoball/triangulation/build.h"
#include "peers/cgal_sites.h"
#include "peers/peer_sites.h"

namespace orthoball::peers {
namespace {

using Row = std::uint32_t;
using Exact = CGAL::Tag_true;
using Weighted = CGAL::Tag_true;

using DelaunayVertex3 = CGAL::Alpha_shape_vertex_base_3<
    Kernel, CGAL::Triangulation_vertex_base_with_info_3<Row, Kernel>, Exact>;
using DelaunayCell3 = CGAL::Alpha_shape_cell_base_3<Kernel, CGAL::Default, Exact>;
using Delaunay3 = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<DelaunayVertex3, DelaunayCell3>>;
using RegularVertex3 = CGAL::Alpha_shape_vertex_base_3<
    Kernel,
    CGAL::Triangulation_vertex_base_with_info_3<Row, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>,
    Exact, Weighted>;
using RegularCell3 =
    CGAL::Alpha_shape_cell_base_3<Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>, Exact,
                                  Weighted>;
using Regular3 = CGAL::Regular_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<RegularVertex3, RegularCell3>>;
using Vertex2 = CGAL::Alpha_shape_vertex_base_2<
    Kernel, CGAL::Triangulation_vertex_base_with_info_2<Row, Kernel>, Exact>;
using Face2 = CGAL::Alpha_shape_face_base_2<Kernel, CGAL::Default, Exact>;
using Delaunay2 =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex2, Face2>>;

// Whether `label` is the double nearest to `value`.
template <class Value>
bool is_nearest(double label, const Value& value) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Value off = CGAL::abs(value - Value(label));
  return off <= CGAL::abs(value - Value(std::nextafter(label, kInfinity))) &&
         off <= CGAL::abs(value - Value(std::nextafter(label, -kInfinity)));
}

// The peer's values from the one at `begin` on are those of our labels.
template <class Iterator>
void expect_spectrum(std::span<const double> labels, Iterator begin, Iterator end) {
  ASSERT_EQ(labels.size(), static_cast<std::size_t>(std::distance(begin, end)));
  for (const double label : labels) EXPECT_TRUE(is_nearest(label, (begin++)->exact())) << label;
}

Rows ascending(Rows rows) {
  std::sort(rows.begin(), rows.end());
  return rows;
}

// In space.

template <class Triangulation>
class Shape3 {
 public:
  using Shape = CGAL::Alpha_shape_3<Triangulation, Exact>;

  Shape3(const Filtration<3>& filtration, const WeightedPoints& points)
      : filtration_(filtration), simplices_(simplices_by_rows(filtration)) {
    const auto sites = cgal_sites<typename Triangulation::Point>(points);
    Triangulation triangulation;
    triangulation.insert(sites.begin(), sites.end());
    shape_ = std::make_unique<Shape>(triangulation, 0, Shape::GENERAL);
  }

  void expect_same_spectrum() const {
    expect_spectrum(filtration_.spectrum(), shape_->alpha_begin(), shape_->alpha_end());
  }

  // The three indices of every simplex, by CGAL's own exact comparisons.
  void expect_same_indices() const {
    std::size_t count = 0;
    for (const auto cell : shape_->finite_cell_handles()) {
      const SimplexId simplex = ours({cell->vertex(0)->info(), cell->vertex(1)->info(),
                                      cell->vertex(2)->info(), cell->vertex(3)->info()});
      EXPECT_EQ(filtration_.enters(simplex), index(cell->get_alpha()));
      ++count;
    }
    for (const auto& facet : shape_->finite_facets()) {
      Rows rows;
      for (int corner = 0; corner < 4; ++corner) {
        if (corner != facet.second) rows.push_back(facet.first->vertex(corner)->info());
      }
      expect_same(ours(rows), shape_->get_alpha_status(facet));
      ++count;
    }
    for (const auto& edge : shape_->finite_edges()) {
      expect_same(
          ours({edge.first->vertex(edge.second)->info(), edge.first->vertex(edge.third)->info()}),
          shape_->get_alpha_status(edge));
      ++count;
    }
    for (const auto vertex : shape_->finite_vertex_handles()) {
      expect_same(ours({vertex->info()}), *vertex->get_alpha_status());
      ++count;
    }
    EXPECT_EQ(count, filtration_.size());
  }

 private:
  SimplexId ours(Rows rows) const { return simplices_.at(ascending(std::move(rows))); }
  template <class Value>
  std::uint32_t index(const Value& value) const {
    const auto place = std::lower_bound(shape_->alpha_begin(), shape_->alpha_end(), value);
    EXPECT_TRUE(place != shape_->alpha_end() && *place == value);
    return static_cast<std::uint32_t>(place - shape_->alpha_begin()) + 1;
  }
  template <class Status>
  void expect_same(SimplexId simplex, const Status& status) const {
    EXPECT_EQ(filtration_.is_attached(simplex), !status.is_Gabriel());
    const auto enters = status.is_Gabriel() ? status.alpha_min() : status.alpha_mid();
    EXPECT_EQ(filtration_.enters(simplex), index(enters));
    EXPECT_EQ(filtration_.regular(simplex), index(status.alpha_mid()));
    EXPECT_EQ(filtration_.interior(simplex),
              status.is_on_chull() ? filtration_.never() : index(status.alpha_max()));
  }

  const Filtration<3>& filtration_;
  std::map<Rows, SimplexId> simplices_;
  std::unique_ptr<Shape> shape_;
};

template <class Check>
void with_shape_3(const WeightedPoints& points, const Check& check) {
  const Filtration<3> filtration(regular_triangulation<3>(points));
  if (filtration.triangulation().affine_dimension() < 3) return;
  if (has_weights(points)) {
    check(Shape3<Regular3>(filtration, points));
  } else {
    check(Shape3<Delaunay3>(filtration, points));
  }
}

TEST(CgalAlphaShape, GivesEverySimplexInSpaceTheSameIndices) {
  for_each_generic_family(3, 150, /*seeds=*/2, [](const WeightedPoints& points) {
    with_shape_3(points, [](const auto& shape) { shape.expect_same_indices(); });
  });
}

TEST(CgalAlphaShape, HasTheSameSpectrumOfAnySitesInSpace) {
  for_each_family(3, 60, /*seeds=*/3, [](const WeightedPoints& points) {
    with_shape_3(points, [](const auto& shape) { shape.expect_same_spectrum(); });
  });
}

// In the plane.

using Shape2 = CGAL::Alpha_shape_2<Delaunay2, Exact>;

Role role(Shape2::Classification_type classified) {
  switch (classified) {
    case Shape2::EXTERIOR:
      return Role::exterior;
    case Shape2::SINGULAR:
      return Role::singular;
    case Shape2::REGULAR:
      return Role::regular;
    default:
      return Role::interior;
  }
}

template <class Check>
void with_shape_2(const WeightedPoints& points, const Check& check) {
  if (has_weights(points)) return;
  const Filtration<2> filtration(regular_triangulation<2>(points));
  if (filtration.triangulation().affine_dimension() < 2) return;
  const auto sites = cgal_sites<Kernel::Point_2>(points);
  Delaunay2 triangulation;
  triangulation.insert(sites.begin(), sites.end());
  const Shape2 shape(triangulation, 0, Shape2::GENERAL);
  check(filtration, shape);
}

TEST(CgalAlphaShape, GivesEdgesAndTrianglesInThePlaneTheSameRoles) {
  for_each_generic_family(2, 300, /*seeds=*/2, [](const WeightedPoints& points) {
    with_shape_2(points, [](const Filtration<2>& filtration, const Shape2& shape) {
      const auto simplices = simplices_by_rows(filtration);
      for (std::uint32_t index = 2; index <= filtration.spectrum_size(); index += 7) {
        const auto alpha2 = *(shape.alpha_begin() + (index - 2));  // 0 is not listed there
        for (const auto face : shape.finite_face_handles()) {
          const Rows rows = ascending(
              {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
          EXPECT_EQ(filtration.role(simplices.at(rows), index), role(shape.classify(face, alpha2)));
        }
        for (const auto& edge : shape.finite_edges()) {
          const Rows rows = ascending({edge.first->vertex((edge.second + 1) % 3)->info(),
                                       edge.first->vertex((edge.second + 2) % 3)->info()});
          EXPECT_EQ(filtration.role(simplices.at(rows), index), role(shape.classify(edge, alpha2)));
        }
      }
    });
  });
}

TEST(CgalAlphaShape, HasTheSameSpectrumOfAnyPointsInThePlane) {
  for_each_family(2, 200, /*seeds=*/4, [](const WeightedPoints& points) {
    with_shape_2(points, [](const Filtration<2>& filtration, const Shape2& shape) {
      EXPECT_EQ(filtration.alpha2(1), 0.0);
      expect_spectrum(filtration.spectrum().subspan(1), shape.alpha_begin(), shape.alpha_end());
    });
  });
}

}  // namespace
}  // namespace orthoball::peers
