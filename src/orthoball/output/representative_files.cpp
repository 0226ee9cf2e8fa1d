// SPDX-License-Identifier: MIT
#include "orthoball/output/representative_files.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace orthoball {
namespace {

template <int D>
class JsonWriter {
 public:
  JsonWriter(ByteSink& sink, const Filtration<D>& filtration)
      : sink_(sink), filtration_(filtration) {}

  void write(std::size_t number, const Representative& one) {
    integer("{\"class\":", static_cast<std::int64_t>(number));
    integer(",\"dimension\":", one.dimension);
    value(",\"birth\":", filtration_.enters(one.pair.birth));
    if (one.pair.death.exists()) {
      value(",\"death\":", filtration_.enters(one.pair.death));
    } else {
      sink_.text(",\"death\":null");
    }
    value(",\"alpha2\":", one.index);
    integer(",\"index\":", one.index);
    sink_.text(",\"rows\":");
    rows(one.rows);
    if (one.dimension == 1) {
      list(",\"rings\":", one.rings, [&](const std::vector<SiteId>& ring) { rows(ring); });
    }
    if (one.dimension == 2) simplices(",\"triangles\":", one.cycle);
    if (one.dimension > 0) real(one.dimension == 1 ? ",\"length\":" : ",\"area\":", one.size);
    if (!one.cells.empty()) {
      simplices(",\"cells\":", one.cells);
      real(",\"volume\":", one.volume);
    }
    sink_.text(",\"birth_simplex\":");
    simplex(one.pair.birth);
    sink_.text(",\"death_simplex\":");
    one.pair.death.exists() ? simplex(one.pair.death) : sink_.text("null");
    sink_.text("}");
  }

 private:
  void integer(std::string_view before, std::int64_t number) {
    sink_.text(before);
    sink_.integer(number);
  }
  void real(std::string_view before, double number) {
    sink_.text(before);
    sink_.real(number + 0.0);
  }
  void value(std::string_view before, std::uint32_t index) {
    real(before, filtration_.alpha2(index));
  }
  template <class Items, class Write>
  void list(std::string_view before, const Items& items, const Write& write) {
    sink_.text(before);
    std::string_view between = "[";
    for (const auto& item : items) {
      sink_.text(between);
      between = ",";
      write(item);
    }
    sink_.text(between == "[" ? "[]" : "]");
  }
  void rows(const std::vector<SiteId>& of) {
    list("", of, [&](SiteId row) { sink_.integer(row.row()); });
  }
  void simplex(SimplexId simplex) {
    FewOf<SiteId, D> ascending;
    for (const SiteId row : filtration_.rows(simplex)) ascending.insert(row);
    rows({ascending.begin(), ascending.end()});
  }
  void simplices(std::string_view before, const std::vector<SimplexId>& of) {
    list(before, of, [&](SimplexId one) { simplex(one); });
  }

  ByteSink& sink_;
  const Filtration<D>& filtration_;
};

// Everything of a PLY, with vertices numbered for it.
struct Mesh {
  struct Vertex {
    SiteId row;
    std::uint32_t of_class;
  };
  struct Face {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t of_class;
    bool is_filling;
  };
  struct Edge {
    std::array<std::uint32_t, 2> vertices;
    std::uint32_t of_class;
  };
  std::vector<Vertex> vertices;
  std::vector<Face> faces;
  std::vector<Edge> edges;
};

template <int D>
void add(Mesh& mesh, const Filtration<D>& filtration, const Representative& one,
         std::uint32_t number) {
  const bool is_filled = one.dimension == 1 && one.pair.death.exists();
  std::set<SiteId> rows(one.rows.begin(), one.rows.end());
  if (is_filled) {
    for (const SiteId row : filtration.rows(one.pair.death)) rows.insert(row);
  }
  std::map<SiteId, std::uint32_t> vertex_of;
  for (const SiteId row : rows) {
    vertex_of[row] = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({row, number});
  }
  const auto face = [&](SimplexId triangle, bool is_filling) {
    Mesh::Face& added = mesh.faces.emplace_back(Mesh::Face{{}, number, is_filling});
    const auto corners = filtration.rows(triangle);
    for (std::size_t i = 0; i < 3; ++i) added.vertices[i] = vertex_of[corners[i]];
  };
  if (one.dimension == 2) {
    for (const SimplexId triangle : one.cycle) face(triangle, false);
  } else if (one.dimension == 1) {
    for (const SimplexId edge : one.cycle) {
      const auto ends = filtration.rows(edge);
      mesh.edges.push_back({{vertex_of[ends[0]], vertex_of[ends[1]]}, number});
    }
    if (is_filled) face(one.pair.death, true);
  }
}

}  // namespace

template <int D>
void write_representatives_json(ByteSink& sink, const Filtration<D>& filtration,
                                std::span<const Representative> representatives) {
  JsonWriter<D> writer(sink, filtration);
  for (std::size_t i = 0; i < representatives.size(); ++i) {
    sink.text(i == 0 ? "[\n" : ",\n");
    writer.write(i + 1, representatives[i]);
  }
  sink.text(representatives.empty() ? "[]\n" : "\n]\n");
  sink.flush();
}

template <int D>
void write_representatives_ply(ByteSink& sink, const Filtration<D>& filtration,
                               const WeightedPoints& points,
                               std::span<const Representative> representatives) {
  Mesh mesh;
  for (std::size_t i = 0; i < representatives.size(); ++i) {
    add(mesh, filtration, representatives[i], static_cast<std::uint32_t>(i + 1));
  }
  const auto element = [&](std::string_view name, std::size_t count, std::string_view properties) {
    sink.text(name);
    sink.integer(static_cast<std::int64_t>(count));
    sink.text(properties);
  };
  sink.text("ply\nformat binary_little_endian 1.0\ncomment classes of persistent homology\n");
  element("element vertex ", mesh.vertices.size(),
          "\nproperty double x\nproperty double y\nproperty double z\nproperty uint row\n"
          "property int class\n");
  element("element face ", mesh.faces.size(),
          "\nproperty list uchar int vertex_indices\nproperty int class\n"
          "property uchar filling\n");
  element("element edge ", mesh.edges.size(),
          "\nproperty int vertex1\nproperty int vertex2\nproperty int class\nend_header\n");
  for (const auto& [row, of_class] : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      sink.little_endian(axis < D ? points.coordinate(row.row(), axis) : 0.0);
    }
    sink.little_endian(row.row());
    sink.little_endian(of_class);
  }
  for (const Mesh::Face& face : mesh.faces) {
    sink.little_endian(std::uint8_t{3});
    for (const std::uint32_t vertex : face.vertices) sink.little_endian(vertex);
    sink.little_endian(face.of_class);
    sink.little_endian(static_cast<std::uint8_t>(face.is_filling ? 1 : 0));
  }
  for (const Mesh::Edge& edge : mesh.edges) {
    for (const std::uint32_t vertex : edge.vertices) sink.little_endian(vertex);
    sink.little_endian(edge.of_class);
  }
  sink.flush();
}

template void write_representatives_json<2>(ByteSink&, const Filtration<2>&,
                                            std::span<const Representative>);
template void write_representatives_json<3>(ByteSink&, const Filtration<3>&,
                                            std::span<const Representative>);
template void write_representatives_ply<2>(ByteSink&, const Filtration<2>&, const WeightedPoints&,
                                           std::span<const Representative>);
template void write_representatives_ply<3>(ByteSink&, const Filtration<3>&, const WeightedPoints&,
                                           std::span<const Representative>);

}  // namespace orthoball
