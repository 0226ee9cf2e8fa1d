// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "orthoball/output/alpha_table.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/queries/alpha_candidates.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/written.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;

namespace {

template <int D>
using Some = std::vector<orthoball::AlphaCandidate<D>>;

// The candidates of a family, which outlives them.
struct Candidates {
  const AlphaShapes* shapes;
  std::variant<Some<2>, Some<3>> candidates;
  std::vector<orthoball::AlphaSpread> spreads;
};

struct Resamples {
  std::uint32_t count;
  double share;
  std::uint64_t seed;
};

Candidates found(const AlphaShapes& shapes, bool is_molecule, const Resamples& resamples,
                 orthoball::Threads threads) {
  const orthoball::WeightMeaning weights = meaning_of_weights(shapes, is_molecule);
  return without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    Some<D> candidates = orthoball::alpha_candidates<D>(filtration, weights, threads);
    std::vector<orthoball::AlphaSpread> spreads;
    if (resamples.count > 0) {
      spreads =
          orthoball::alpha_spreads<D>(shapes.points(), candidates, weights,
                                      {resamples.count, resamples.share, resamples.seed}, threads);
    }
    return Candidates{&shapes, std::move(candidates), std::move(spreads)};
  });
}

nb::bytes file(const Candidates& self, const std::string& format) {
  return written_table(format, [&](orthoball::ByteSink& sink, orthoball::TableFormat of_table) {
    std::visit(
        [&]<int D>(const Some<D>& candidates) {
          const auto& filtration = std::get<Filtration<D>>(self.shapes->filtration());
          orthoball::write_alpha_candidates<D>(sink, of_table, filtration, candidates,
                                               self.spreads);
        },
        self.candidates);
  });
}

}  // namespace

void bind_alpha_candidates(nb::module_& module) {
  nb::class_<Candidates>(module, "Candidates", "See orthoball.AlphaCandidates.")
      .def("file", &file, nb::arg("format"), "All as a table, csv or json.");
  module.def(
      "alpha_candidates",
      [](const AlphaShapes& shapes, bool is_molecule, std::uint32_t resamples, double share,
         std::uint64_t seed, std::optional<unsigned> threads) {
        return found(shapes, is_molecule, {resamples, share, seed}, threads_of(threads));
      },
      nb::arg("shapes"), nb::arg("is_molecule"), nb::arg("resamples"), nb::arg("share"),
      nb::arg("seed"), nb::arg("threads").none(), nb::keep_alive<0, 1>(),
      "Alphas that may be the ones to take.");
  module.def("candidate_names", &orthoball::candidate_names, nb::arg("dimension"),
             "The names that candidates can have.");
  module.def(
      "scale_text",
      [](const AlphaShapes& shapes) {
        return without_gil(shapes, [](const auto& f) { return orthoball::scale_text(f); });
      },
      nb::arg("shapes"), "The alphas of the points in words.");
}
