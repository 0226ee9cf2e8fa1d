// SPDX-License-Identifier: MIT
#include "orthoball/output/region_mesh.h"

#include <map>

#include "orthoball/output/shape_mesh.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNoRegion = 0xFFFFFFFFU;

// The facets of a region in vertices of the triangulation, and its vertices in their order.
template <int D>
void append_region(RegionMesh<D>& mesh, const Filtration<D>& filtration,
                   const WeightedPoints& points, std::size_t first_facet) {
  std::map<std::uint32_t, std::uint32_t> number;
  for (std::size_t i = first_facet; i < mesh.facets.size(); ++i) {
    for (const std::uint32_t v : mesh.facets[i]) number[v] = 0;
  }
  const auto& sites = filtration.triangulation().sites();
  for (auto& [vertex, its_number] : number) {
    its_number = static_cast<std::uint32_t>(mesh.rows.size());
    const SiteId row = sites.row(vertex);
    mesh.rows.push_back(row);
    for (int axis = 0; axis < 3; ++axis) {
      mesh.coordinates.push_back(axis < D ? points.coordinate(row.row(), axis) : 0.0);
    }
  }
  for (std::size_t i = first_facet; i < mesh.facets.size(); ++i) {
    for (std::uint32_t& v : mesh.facets[i]) v = number[v];
  }
}

}  // namespace

template <int D>
RegionMesh<D> region_mesh(const Filtration<D>& filtration, const WeightedPoints& points,
                          std::uint32_t index,
                          std::span<const std::span<const SimplexId>> regions) {
  const auto cells = filtration.triangulation().template cells<D>();
  const auto& table = filtration.table();
  std::vector<std::uint32_t> region_of_cell(cells.size(), kNoRegion);
  for (std::uint32_t region = 0; region < regions.size(); ++region) {
    for (const SimplexId cell : regions[region]) {
      region_of_cell[cell.row() - table.first(D)] = region;
    }
  }
  RegionMesh<D> mesh;
  mesh.index = index;
  for (std::uint32_t region = 0; region < regions.size(); ++region) {
    const std::size_t first_facet = mesh.facets.size();
    for (const SimplexId id : regions[region]) {
      const std::uint32_t cell = id.row() - table.first(D);
      for (unsigned corner = 0; corner <= D; ++corner) {
        const std::uint32_t beyond = cells[cell].neighbours[corner];
        if (beyond != kOutside && region_of_cell[beyond / 4] == region) continue;
        auto& facet = mesh.facets.emplace_back();
        const auto outward = outward_facet<D>(cells[cell], corner);
        for (std::size_t i = 0; i < D; ++i) facet[i] = outward[i].row();
        const SimplexId simplex(table.first(D - 1) +
                                table.template facet_of_cell<D>(cells, cell, corner));
        mesh.regions.push_back(region);
        mesh.are_open.push_back(filtration.enters(simplex) > index);
      }
    }
    append_region(mesh, filtration, points, first_facet);
  }
  return mesh;
}

template <int D>
void write_region_ply(ByteSink& sink, const RegionMesh<D>& mesh, const RegionMeshText& text) {
  const auto line = [&](std::string_view before, std::size_t number) {
    sink.text(before);
    sink.integer(static_cast<std::int64_t>(number));
    sink.text("\n");
  };
  sink.text("ply\nformat binary_little_endian 1.0\ncomment ");
  sink.text(text.title);
  line("\nelement vertex ", mesh.rows.size());
  sink.text("property double x\nproperty double y\nproperty double z\nproperty uint row\n");
  line(D == 3 ? "element face " : "element edge ", mesh.facets.size());
  sink.text(D == 3 ? "property list uchar int vertex_indices\n"
                   : "property int vertex1\nproperty int vertex2\n");
  sink.text("property int ");
  sink.text(text.name);
  sink.text(text.mouths ? "\nproperty uchar mouth\nend_header\n" : "\nend_header\n");

  for (std::size_t v = 0; v < mesh.rows.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sink.little_endian(mesh.coordinates[3 * v + axis]);
    }
    sink.little_endian(mesh.rows[v].row());
  }
  for (std::size_t i = 0; i < mesh.facets.size(); ++i) {
    if (D == 3) sink.little_endian(std::uint8_t{3});
    for (const std::uint32_t v : mesh.facets[i]) sink.little_endian(v);
    sink.little_endian(mesh.regions[i] + 1);
    if (text.mouths) sink.little_endian(static_cast<std::uint8_t>(mesh.are_open[i] ? 1 : 0));
  }
  sink.flush();
}

template RegionMesh<2> region_mesh(const Filtration<2>&, const WeightedPoints&, std::uint32_t,
                                   std::span<const std::span<const SimplexId>>);
template RegionMesh<3> region_mesh(const Filtration<3>&, const WeightedPoints&, std::uint32_t,
                                   std::span<const std::span<const SimplexId>>);
template void write_region_ply(ByteSink&, const RegionMesh<2>&, const RegionMeshText&);
template void write_region_ply(ByteSink&, const RegionMesh<3>&, const RegionMeshText&);

}  // namespace orthoball
