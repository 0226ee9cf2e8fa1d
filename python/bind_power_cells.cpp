// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "orthoball/output/union_figure.h"
#include "orthoball/queries/planar_union.h"
#include "orthoball/queries/power_cells.h"
#include "python/arrays.h"
#include "python/box.h"
#include "python/module.h"
#include "python/written.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;

namespace {

// The surface of a cell: its corners (k, D), and of every facet the neighbour and its corners.
template <int D>
nb::tuple surface(orthoball::PowerCell<D> cell) {
  nb::list facets;
  for (const orthoball::PowerFacet& facet : cell.facets) {
    const std::vector<std::uint32_t> loop(cell.loops.begin() + facet.begin,
                                          cell.loops.begin() + facet.end);
    facets.append(nb::make_tuple(facet.neighbour.row(), owned<std::uint32_t>(loop)));
  }
  const std::size_t corners = cell.corners.size();
  return nb::make_tuple(owned<double>(std::move(cell.corners), {corners, std::size_t{D}}), facets);
}

template <int D>
nb::dict listed(std::vector<orthoball::PowerCell<D>> cells, bool surfaces) {
  std::vector<orthoball::SiteId> rows;
  std::vector<double> volumes, areas, exposed_areas;
  std::vector<std::uint32_t> facet_counts;
  std::vector<std::uint8_t> are_clipped;
  nb::list of_surfaces;
  for (orthoball::PowerCell<D>& cell : cells) {
    rows.push_back(cell.row);
    volumes.push_back(cell.volume);
    areas.push_back(cell.area);
    exposed_areas.push_back(cell.exposed_area);
    facet_counts.push_back(cell.facet_count);
    are_clipped.push_back(cell.is_clipped ? 1 : 0);
    if (surfaces) of_surfaces.append(surface(std::move(cell)));
  }
  nb::dict result;
  result["rows"] = owned<std::uint32_t>(std::move(rows));
  result["volumes"] = owned<double>(std::move(volumes));
  result["areas"] = owned<double>(std::move(areas));
  result["exposed_area"] = owned<double>(std::move(exposed_areas));
  result["facet_counts"] = owned<std::uint32_t>(std::move(facet_counts));
  result["are_clipped"] = owned<bool>(std::move(are_clipped));
  result["surfaces"] = nb::tuple(of_surfaces);
  return result;
}

// Cut by a box: lower corner, then upper; by default that around the balls.
nb::dict power_cells(const AlphaShapes& shapes, const MaybeBox& typed, bool surfaces,
                     std::optional<unsigned> threads) {
  return std::visit(
      [&]<int D>(const Filtration<D>& filtration) {
        auto cells = [&] {
          const nb::gil_scoped_release released;
          return orthoball::power_cells<D>(filtration, box_of<D>(filtration, typed),
                                           {.surfaces = surfaces, .threads = threads_of(threads)});
        }();
        return listed<D>(std::move(cells), surfaces);
      },
      shapes.filtration());
}

nb::dict power_cells_in_balls(const AlphaShapes& shapes, const orthoball::UnionOfBalls& balls,
                              bool surfaces, double tolerance, std::optional<unsigned> threads) {
  return std::visit(
      [&]<int D>(const Filtration<D>& filtration) {
        auto cells = [&] {
          const nb::gil_scoped_release released;
          return orthoball::power_cells_in_balls<D>(
              filtration, balls,
              {.surfaces = surfaces, .tolerance = tolerance, .threads = threads_of(threads)});
        }();
        return listed<D>(std::move(cells), surfaces);
      },
      shapes.filtration());
}

const Filtration<2>& plane(const AlphaShapes& shapes) {
  if (shapes.dimension() == 2) return std::get<Filtration<2>>(shapes.filtration());
  refuse("the points are in space; the outline is that of disks in the plane");
}

// Closed curves, each (rows (k,), arcs (k, 8): centre, radius, from, to, turn).
nb::list outline(const AlphaShapes& shapes, std::uint32_t index, double alpha2) {
  orthoball::PlanarUnion found;
  {
    const Filtration<2>& filtration = plane(shapes);
    const nb::gil_scoped_release released;
    found = orthoball::planar_union(filtration, index, alpha2);
  }
  nb::list curves;
  for (const auto& curve : found.outline) {
    std::vector<orthoball::SiteId> rows;
    std::vector<std::array<double, 8>> arcs;
    for (const orthoball::OutlineArc& arc : curve) {
      const orthoball::DiskPart& part = found.parts[arc.part];
      const orthoball::DiskPiece& piece = part.boundary[arc.piece];
      rows.push_back(part.row);
      arcs.push_back({part.centre[0], part.centre[1], part.radius, piece.from[0], piece.from[1],
                      piece.to[0], piece.to[1], piece.turn});
    }
    const std::size_t size = rows.size();
    curves.append(nb::make_tuple(owned<std::uint32_t>(std::move(rows)),
                                 owned<double>(std::move(arcs), {size, 8})));
  }
  return curves;
}

nb::bytes figure(const AlphaShapes& shapes, std::uint32_t index, double alpha2,
                 const std::vector<std::string>& panels, bool print, bool legend,
                 const std::string& title) {
  orthoball::UnionFigureOptions options;
  options.index = index;
  options.alpha2 = alpha2;
  options.style = print ? orthoball::FigureStyle::print : orthoball::FigureStyle::colour;
  options.legend = legend;
  options.title = title;
  options.panels.clear();
  for (const std::string& panel : panels) {
    if (panel == "disks")
      options.panels.push_back(orthoball::FigurePanel::disks);
    else if (panel == "cells")
      options.panels.push_back(orthoball::FigurePanel::cells);
    else if (panel == "complex")
      options.panels.push_back(orthoball::FigurePanel::complex);
    else
      refuse("\"" + panel + "\" is no panel; they are disks, cells and complex");
  }
  const Filtration<2>& filtration = plane(shapes);
  return written("0", [&](orthoball::ByteSink& sink) {
    write_union_figure(sink, filtration, shapes.points(), options);
  });
}

}  // namespace

void bind_power_cells(nb::module_& module) {
  module.def("power_cells", &power_cells, nb::arg("shapes"), nb::arg("box").none(),
             nb::arg("surfaces"), nb::arg("threads").none(), "The power cells cut by a box.");
  module.def("power_cells_in_balls", &power_cells_in_balls, nb::arg("shapes"), nb::arg("balls"),
             nb::arg("surfaces"), nb::arg("tolerance"), nb::arg("threads").none(),
             "The power cells cut by their balls.");
  module.def("outline", &outline, nb::arg("shapes"), nb::arg("index"), nb::arg("alpha2"),
             "Closed curves of arcs: rows (k,), and (k, 8): centre, radius, from, to, turn.");
  module.def("figure", &figure, nb::arg("shapes"), nb::arg("index"), nb::arg("alpha2"),
             nb::arg("panels"), nb::arg("print"), nb::arg("legend"), nb::arg("title"),
             "The union of disks and its dual complex as SVG.");
}
