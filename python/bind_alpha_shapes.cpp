// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/input/probe_radius.h"
#include "orthoball/input/read.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/points/probe.h"
#include "python/module.h"
#include "python/points_arrays.h"

using orthoball::AlphaShapes;

namespace {

using MaybeThreads = std::optional<unsigned>;

orthoball::WeightedPoints weighted_points(const Given<double, 2>& points,
                                          const std::optional<Given<double, 1>>& weights,
                                          bool are_radii) {
  using orthoball::WeightKind;
  std::vector<double> coordinates(points.data(), points.data() + points.size());
  std::vector<double> column;
  if (weights) column.assign(weights->data(), weights->data() + weights->size());
  const auto kind = !weights    ? WeightKind::none
                    : are_radii ? WeightKind::radius
                                : WeightKind::weight;
  return {static_cast<int>(points.shape(1)), std::move(coordinates), kind, std::move(column)};
}

AlphaShapes built(orthoball::WeightedPoints points, MaybeThreads threads) {
  const nb::gil_scoped_release released;
  return AlphaShapes(std::move(points), {.threads = threads_of(threads)});
}

template <class Visit>
auto visited(const AlphaShapes& shapes, const Visit& visit) {
  return std::visit(visit, shapes.filtration());
}

// 1 / (x |x|), the square carried to twice the bits of a double.
double inverse_square(double x) {
  const double square = x * x, rest = std::fma(x, x, -square);
  const double quotient = 1.0 / square;
  if (!std::isnormal(square) || !std::isnormal(quotient)) return std::copysign(quotient, x);
  const double error = std::fma(-quotient, square, 1.0) - quotient * rest;
  return std::copysign(quotient + error * quotient, x);
}

struct AlphaForms {
  std::optional<double> alpha2, alpha, inverse_alpha;
  std::optional<std::int64_t> index;
};

// The index and alpha2 of the one form that is given.
std::pair<std::uint32_t, double> chosen(const AlphaShapes& shapes, const AlphaForms& forms) {
  const int given = int{forms.alpha2.has_value()} + int{forms.alpha.has_value()} +
                    int{forms.inverse_alpha.has_value()} + int{forms.index.has_value()};
  if (given != 1) refuse("one of alpha2, alpha, inverse_alpha and index must be given");
  if (forms.index) {
    const std::uint32_t size = visited(shapes, [](const auto& f) { return f.spectrum_size(); });
    if (*forms.index < 0 || *forms.index > std::int64_t{size}) {
      refuse(fmt::format("index {} is not one of the spectrum's; indices are 0 to {}", *forms.index,
                         size));
    }
    const auto index = static_cast<std::uint32_t>(*forms.index);
    const double alpha2 = index == 0
                              ? -std::numeric_limits<double>::infinity()
                              : visited(shapes, [&](const auto& f) { return f.alpha2(index); });
    return {index, alpha2};
  }
  const double number = forms.alpha2  ? *forms.alpha2
                        : forms.alpha ? *forms.alpha
                                      : *forms.inverse_alpha;
  if (std::isnan(number)) refuse("alpha is NaN; it must be a number");
  if (forms.inverse_alpha && number == 0.0) refuse("inverse_alpha is 0; 1/alpha must not be 0");
  const double alpha2 = forms.alpha2  ? number
                        : forms.alpha ? number * std::abs(number)
                                      : inverse_square(number);
  return {visited(shapes, [&](const auto& f) { return f.index(alpha2); }), alpha2};
}

std::string text_of(const AlphaShapes& shapes) {
  return visited(shapes, [&](const auto& filtration) {
    return fmt::format(
        "<orthoball.AlphaShapes of {} sites in {}: {} simplices, {} distinct alpha2>",
        shapes.points().size(), shapes.dimension() == 2 ? "the plane" : "space", filtration.size(),
        filtration.spectrum_size());
  });
}

AlphaShapes with_probe(const AlphaShapes& shapes, double probe, MaybeThreads threads) {
  // As the shortest decimal that is this number, so that 1.4 is seven fifths.
  if (!(probe >= 0.0) || std::isinf(probe)) {
    refuse(fmt::format("the radius of the probe is {}; it must be 0 or more, and finite", probe));
  }
  const orthoball::ProbeRadius radius = orthoball::probe_radius(orthoball::shortest_text(probe));
  const nb::gil_scoped_release released;
  return AlphaShapes(orthoball::with_probe(shapes.points(), radius),
                     {.threads = threads_of(threads)});
}

}  // namespace

void bind_alpha_shapes(nb::module_& module) {
  auto shapes = nb::class_<AlphaShapes>(
      module, "AlphaShapes", "The filtration of weighted points; see orthoball.AlphaShapes.");
  shapes
      .def(
          "__init__",
          [](AlphaShapes* self, const Given<double, 2>& points,
             const std::optional<Given<double, 1>>& weights, bool are_radii, MaybeThreads threads) {
            new (self) AlphaShapes(built(weighted_points(points, weights, are_radii), threads));
          },
          nb::arg("points"), nb::arg("weights").none(), nb::arg("are_radii"),
          nb::arg("threads").none())
      .def(
          "__init__",
          [](AlphaShapes* self, const orthoball::Reading& reading, MaybeThreads threads) {
            new (self) AlphaShapes(built(reading.points, threads));
          },
          nb::arg("reading"), nb::arg("threads").none())
      .def("__repr__", &text_of)
      .def("with_probe", &with_probe, nb::arg("probe"), nb::arg("threads").none(),
           "The shapes of the balls grown by the radius of a probe.");
  shapes.def_prop_ro("dimension", &AlphaShapes::dimension, "2 or 3.")
      .def_prop_ro(
          "affine_dimension",
          [](const AlphaShapes& self) {
            return visited(self,
                           [](const auto& f) { return f.triangulation().affine_dimension(); });
          },
          "Of the sites' affine hull; -1 without sites.")
      .def_prop_ro(
          "site_count", [](const AlphaShapes& self) { return self.points().size(); }, "Input rows.")
      .def_prop_ro(
          "decimals", [](const AlphaShapes& self) { return self.points().decimals(); },
          "As that of a Reading.")
      .def_prop_ro(
          "points",
          [](nb::handle self) {
            return coordinate_array(nb::cast<const AlphaShapes&>(self).points(), self);
          },
          nb::rv_policy::automatic,
          nb::sig("def points(self) -> numpy.typing.NDArray[numpy.float64]"),
          "(n, D) float64, input units.")
      .def_prop_ro(
          "weights", [](const AlphaShapes& self) { return weights_of(self.points()); },
          nb::sig("def weights(self) -> numpy.typing.NDArray[numpy.float64] | None"),
          "(n,) float64, length^2; None without weights.");
  shapes
      .def_prop_ro(
          "spectrum",
          [](nb::handle self) {
            return visited(nb::cast<const AlphaShapes&>(self), [&](const auto& filtration) {
              const auto spectrum = filtration.spectrum();
              return view<double>(spectrum, self, {spectrum.size()});
            });
          },
          nb::sig("def spectrum(self) -> numpy.typing.NDArray[numpy.float64]"),
          "(s,) float64, length^2.")
      .def_prop_ro(
          "hidden",
          [](nb::handle self) {
            return visited(nb::cast<const AlphaShapes&>(self), [&](const auto& filtration) {
              const auto hidden = filtration.triangulation().hidden();
              return view<std::uint32_t>(hidden, self, {hidden.size()});
            });
          },
          nb::sig("def hidden(self) -> numpy.typing.NDArray[numpy.uint32]"), "(k,) uint32 rows.")
      .def_prop_ro(
          "duplicates",
          [](nb::handle self) {
            return visited(nb::cast<const AlphaShapes&>(self), [&](const auto& filtration) {
              const auto duplicates = filtration.triangulation().duplicates();
              return view<std::uint32_t>(duplicates, self, {duplicates.size(), 2});
            });
          },
          nb::sig("def duplicates(self) -> numpy.typing.NDArray[numpy.uint32]"),
          "(k, 2) uint32: row, representative.");
  shapes
      .def(
          "index",
          [](const AlphaShapes& self, double alpha2) {
            return chosen(self, {.alpha2 = alpha2, .alpha = {}, .inverse_alpha = {}, .index = {}})
                .first;
          },
          nb::arg("alpha2"), "Number of entries of the spectrum that are <= alpha2.")
      .def(
          "indices",
          [](const AlphaShapes& self, const Given<double, 1>& alpha2) {
            std::vector<std::uint32_t> indices;
            for (std::size_t i = 0; i < alpha2.size(); ++i) {
              indices.push_back(
                  chosen(
                      self,
                      {.alpha2 = alpha2.data()[i], .alpha = {}, .inverse_alpha = {}, .index = {}})
                      .first);
            }
            return owned<std::uint32_t>(std::move(indices));
          },
          nb::arg("alpha2"), "index() of each.")
      .def(
          "chosen",
          [](const AlphaShapes& self, std::optional<double> alpha2, std::optional<double> alpha,
             std::optional<double> inverse_alpha, std::optional<std::int64_t> index) {
            return chosen(self, {alpha2, alpha, inverse_alpha, index});
          },
          nb::arg("alpha2").none(), nb::arg("alpha").none(), nb::arg("inverse_alpha").none(),
          nb::arg("index").none(), "The index and alpha2 of the one form that is given.");
}
