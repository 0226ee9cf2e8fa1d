// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <vector>

#include "orthoball/queries/pockets.h"
#include "orthoball/queries/voids.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/simplex_rows.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::SiteId;

namespace {

// What voids and pockets have in common, in Python's words.
template <int D, class Region>
nb::dict region(const Filtration<D>& filtration, const Region& found) {
  std::vector<SiteId> rows;
  std::vector<double> areas;
  for (const orthoball::LiningBall& ball : found.lining) {
    rows.push_back(ball.row);
    areas.push_back(ball.area);
  }
  nb::dict result;
  result["volume"] = found.volume;
  result["area"] = found.area;
  result["rows"] = owned<std::uint32_t>(std::move(rows));
  result["areas"] = owned<double>(std::move(areas));
  result["cells"] = rows_of(filtration, found.cells, std::size_t{D} + 1);
  return result;
}

template <int D>
nb::dict as_dict(const Filtration<D>& filtration, const orthoball::Void<D>& found) {
  nb::dict result = region(filtration, found);
  result["born"] = found.born;
  result["dies"] = found.dies;
  result["born_alpha2"] = found.born_alpha2;
  result["dies_alpha2"] = found.dies_alpha2;
  result["largest_ball_centre"] = owned<double>(
      std::vector<double>(found.largest_ball_centre.begin(), found.largest_ball_centre.end()));
  result["largest_ball_radius"] = found.largest_ball_radius;
  return result;
}

template <int D>
nb::dict as_dict(const Filtration<D>& filtration, const orthoball::Pocket& found) {
  nb::dict result = region(filtration, found);
  nb::list mouths;
  for (const orthoball::Mouth& mouth : found.mouths) {
    nb::dict one;
    one["area"] = mouth.area;
    one["rim"] = owned<std::uint32_t>(std::vector<SiteId>(mouth.rim));
    one["facets"] = rows_of(filtration, mouth.facets, std::size_t{D});
    mouths.append(one);
  }
  result["mouths"] = mouths;
  result["depth"] = found.depth;
  return result;
}

// What `find` gives without the GIL, as a list of dicts.
template <class Find>
nb::list listed(const AlphaShapes& shapes, const Find& find) {
  return std::visit(
      [&]<int D>(const Filtration<D>& filtration) {
        const auto found = [&] {
          const nb::gil_scoped_release released;
          return find(filtration);
        }();
        nb::list result;
        for (const auto& one : found) result.append(as_dict(filtration, one));
        return result;
      },
      shapes.filtration());
}

}  // namespace

void bind_free_space(nb::module_& module) {
  using MaybeThreads = std::optional<unsigned>;
  module.def(
      "voids",
      [](const AlphaShapes& shapes, std::uint32_t index, double alpha2, bool of_shape,
         MaybeThreads threads) {
        return listed(shapes, [&]<int D>(const Filtration<D>& filtration) {
          const auto of = of_shape ? orthoball::VoidsOf::shape : orthoball::VoidsOf::balls;
          return orthoball::voids<D>(filtration, index, alpha2, of, threads_of(threads));
        });
      },
      nb::arg("shapes"), nb::arg("index"), nb::arg("alpha2"), nb::arg("of_shape"),
      nb::arg("threads").none(), "Voids of the balls or of the shape, a dict each.");
  module.def(
      "pockets",
      [](const AlphaShapes& shapes, std::uint32_t index, double alpha2, MaybeThreads threads) {
        return listed(shapes, [&]<int D>(const Filtration<D>& filtration) {
          return orthoball::pockets<D>(filtration, index, alpha2, threads_of(threads));
        });
      },
      nb::arg("shapes"), nb::arg("index"), nb::arg("alpha2"), nb::arg("threads").none(),
      "Pockets of the balls, a dict each.");
}
