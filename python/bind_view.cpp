// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "orthoball/input/read.h"
#include "orthoball/output/page.h"
#include "python/module.h"
#include "python/written.h"

using orthoball::AlphaShapes;
using orthoball::Reading;

namespace nb = nanobind;

namespace {

// The page of `orthoball view` for the file of a reading, or for points that come from no file.
nb::bytes page(const AlphaShapes& shapes, const Reading* reading, bool is_molecule,
               const nb::bytes& viewer, std::uint32_t index, double alpha2,
               const std::string& chosen_because, std::optional<unsigned> threads) {
  const bool has_weights = shapes.points().weight_kind() != orthoball::WeightKind::none;
  const orthoball::SnapshotFacts facts{
      .source = reading ? std::filesystem::path(reading->file).filename().string() : "points",
      .unit = is_molecule ? "Å" : "",
      .radii = reading       ? reading->radii
               : has_weights ? "given"
                             : "none",
      .weights = meaning_of_weights(shapes, is_molecule),
      .index = index,
      .alpha2 = alpha2,
      .chosen_because = chosen_because};
  const std::string_view bytes(viewer.c_str(), viewer.size());
  return written("", [&](orthoball::ByteSink& sink) {
    std::visit(
        [&](const auto& filtration) {
          write_page(sink, bytes, filtration, shapes.points(), labels_of(reading), facts,
                     threads_of(threads));
        },
        shapes.filtration());
  });
}

}  // namespace

void bind_view(nb::module_& module) {
  module.def("page", &page, nb::arg("shapes"), nb::arg("reading").none(), nb::arg("is_molecule"),
             nb::arg("viewer"), nb::arg("index"), nb::arg("alpha2"), nb::arg("chosen_because"),
             nb::arg("threads").none(), "The viewer's page with all shapes in it.");
}
