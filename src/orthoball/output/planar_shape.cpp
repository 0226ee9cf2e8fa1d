// SPDX-License-Identifier: MIT
#include "orthoball/output/planar_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "orthoball/output/alpha_text.h"
#include "orthoball/output/polygons.h"

namespace orthoball {
namespace {

// Calls `visit(vertices)` for every singular simplex of a dimension below 2.
template <class Visit>
void for_singular(const AlphaComplex<2>& complex, int dimension, const Visit& visit) {
  const Filtration<2>& filtration = complex.filtration();
  const std::uint32_t first = filtration.table().first(dimension);
  for (std::uint32_t i = 0; i < filtration.count(dimension); ++i) {
    const SimplexId simplex(first + i);
    if (complex.role(simplex) == Role::singular) visit(filtration.vertices(simplex));
  }
}

// The members of a JSON array with commas between them: "[", one `write(member)` each, "]".
template <class Members, class Write>
void write_array(ByteSink& sink, const Members& members, const Write& write) {
  sink.text("[");
  bool is_first = true;
  for (const auto& member : members) {
    if (!is_first) sink.text(",");
    is_first = false;
    write(member);
  }
  sink.text("]");
}

class GeoJson {
 public:
  GeoJson(ByteSink& sink, const Sites<2>& sites, const WeightedPoints& points)
      : sink_(sink), sites_(sites), points_(points) {
    sink_.text("{\"type\":\"FeatureCollection\",\"features\":[");
  }
  void polygons(const std::vector<Polygon>& polygons, double alpha2, std::uint32_t index) {
    begin_feature("MultiPolygon");
    write_array(sink_, polygons, [&](const Polygon& polygon) {
      write_array(sink_, polygon.rings, [&](const std::vector<VertexId>& ring) {
        std::vector<VertexId> closed = ring;
        closed.push_back(ring.front());
        write_array(sink_, closed, [&](VertexId v) { position(v); });
      });
    });
    properties("regular");
    sink_.text(",\"alpha2\":");
    sink_.real(alpha2);
    sink_.text(",\"index\":");
    sink_.integer(index);
    sink_.text(",\"rows\":");
    write_array(sink_, polygons, [&](const Polygon& polygon) {
      write_array(sink_, polygon.rings, [&](const std::vector<VertexId>& ring) {
        write_array(sink_, ring, [&](VertexId v) { row(v); });
      });
    });
    sink_.text("}}");
  }
  void edge(const FewOf<VertexId, 2>& ends) {
    begin_feature("LineString");
    write_array(sink_, ends, [&](VertexId v) { position(v); });
    properties("singular");
    sink_.text(",\"rows\":");
    write_array(sink_, ends, [&](VertexId v) { row(v); });
    sink_.text("}}");
  }
  void vertex(VertexId v) {
    begin_feature("Point");
    position(v);
    properties("singular");
    sink_.text(",\"row\":");
    row(v);
    sink_.text("}}");
  }
  void end() { sink_.text("\n]}\n"); }

 private:
  void begin_feature(std::string_view type) {
    sink_.text(is_first_ ? "\n" : ",\n");
    is_first_ = false;
    sink_.text("{\"type\":\"Feature\",\"geometry\":{\"type\":");
    sink_.json_string(type);
    sink_.text(",\"coordinates\":");
  }
  void properties(std::string_view role) {
    sink_.text("},\"properties\":{\"role\":");
    sink_.json_string(role);
  }
  void position(VertexId v) {
    sink_.text("[");
    sink_.real(points_.coordinate(sites_.row(v.row()).row(), 0));
    sink_.text(",");
    sink_.real(points_.coordinate(sites_.row(v.row()).row(), 1));
    sink_.text("]");
  }
  void row(VertexId v) { sink_.integer(sites_.row(v.row()).row()); }

  ByteSink& sink_;
  const Sites<2>& sites_;
  const WeightedPoints& points_;
  bool is_first_ = true;
};

constexpr double kPictureSize = 800.0;  // the longer side, without the margin
constexpr double kMargin = 20.0;

// Where a vertex lies in the picture, in units of it, rounded to 1/100.
class Picture {
 public:
  Picture(const Sites<2>& sites, const WeightedPoints& points) : sites_(sites), points_(points) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t v = 0; v < sites.size(); ++v) {
        const double x = points.coordinate(sites.row(v).row(), static_cast<int>(axis));
        low = std::min(low, x);
        high = std::max(high, x);
      }
      if (sites.size() == 0) low = high = 0.0;
      low_[axis] = low / 2;  // halves, because a difference of doubles can overflow
      extent_[axis] = high / 2 - low / 2;
    }
    const double longest = std::max(extent_[0], extent_[1]);
    scale_ = longest > 0.0 ? kPictureSize / longest : 1.0;
  }
  [[nodiscard]] double width() const { return extent_[0] * scale_ + 2 * kMargin; }
  [[nodiscard]] double height() const { return extent_[1] * scale_ + 2 * kMargin; }
  void position(ByteSink& sink, VertexId v) const {
    const std::size_t row = sites_.row(v.row()).row();
    const double x = (points_.coordinate(row, 0) / 2 - low_[0]) * scale_;
    const double y = (extent_[1] - (points_.coordinate(row, 1) / 2 - low_[1])) * scale_;
    sink.real(std::round(100 * (x + kMargin)) / 100);
    sink.text(" ");
    sink.real(std::round(100 * (y + kMargin)) / 100);
  }
  // A point of no length; round line caps make it a disc.
  void dot(ByteSink& sink, VertexId v) const {
    sink.text("M");
    position(sink, v);
    sink.text("h0");
  }

 private:
  const Sites<2>& sites_;
  const WeightedPoints& points_;
  double low_[2] = {}, extent_[2] = {}, scale_ = 1.0;
};

}  // namespace

void write_geojson(ByteSink& sink, const AlphaComplex<2>& complex, const WeightedPoints& points,
                   const PlanarShapeOptions& options) {
  GeoJson json(sink, complex.filtration().triangulation().sites(), points);
  if (const auto parts = polygons(complex); !parts.empty()) {
    json.polygons(parts, options.alpha2, complex.index());
  }
  for_singular(complex, 1, [&](const FewOf<VertexId, 2>& ends) { json.edge(ends); });
  for_singular(complex, 0, [&](const FewOf<VertexId, 2>& vertex) { json.vertex(vertex[0]); });
  json.end();
  sink.flush();
}

void write_shape_svg(ByteSink& sink, const AlphaComplex<2>& complex, const WeightedPoints& points,
                     const PlanarShapeOptions& options) {
  const Sites<2>& sites = complex.filtration().triangulation().sites();
  const Picture picture(sites, points);
  const auto size = [](double x) { return shortest_text(std::ceil(x)); };
  const std::string width = size(picture.width()), height = size(picture.height());
  sink.text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
            "\" viewBox=\"0 0 " + width + " " + height + "\">\n<title>Alpha shape at " +
            alpha_text(options.alpha2, complex.index()) +
            "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
  sink.text("<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");

  sink.text(
      "<path class=\"regular\" fill=\"#cfe3f5\" fill-rule=\"evenodd\" "
      "stroke=\"#1f5a94\" stroke-width=\"1.5\" d=\"");
  for (const Polygon& polygon : polygons(complex)) {
    for (const auto& ring : polygon.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        sink.text(i == 0 ? "M" : "L");
        picture.position(sink, ring[i]);
      }
      sink.text("Z");
    }
  }
  sink.text("\"/>\n<path class=\"sites\" stroke=\"#8fa3b5\" stroke-width=\"2.5\" d=\"");
  for (std::uint32_t v = 0; v < sites.size(); ++v) picture.dot(sink, VertexId(v));
  const std::string singular_colour = options.roles ? "#d55e00" : "#1f5a94";
  sink.text("\"/>\n<path class=\"singular edges\" stroke=\"" + singular_colour +
            "\" stroke-width=\"1.5\" d=\"");
  for_singular(complex, 1, [&](const FewOf<VertexId, 2>& ends) {
    sink.text("M");
    picture.position(sink, ends[0]);
    sink.text("L");
    picture.position(sink, ends[1]);
  });
  sink.text("\"/>\n<path class=\"singular vertices\" stroke=\"" + singular_colour +
            "\" stroke-width=\"4\" d=\"");
  for_singular(complex, 0, [&](const FewOf<VertexId, 2>& vertex) { picture.dot(sink, vertex[0]); });
  sink.text("\"/>\n</g>\n</svg>\n");
  sink.flush();
}

}  // namespace orthoball
