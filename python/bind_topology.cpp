// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>

#include <vector>

#include "orthoball/topology/betti.h"
#include "orthoball/topology/persistence.h"
#include "python/arrays.h"
#include "python/module.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::PersistencePair;
using orthoball::SimplexId;
using orthoball::SiteId;

namespace {

// What Python gets of the pairs of one dimension.
struct Diagram {
  std::vector<std::uint32_t> indices;  // 2 a pair
  std::vector<double> alpha2;          // 2 a pair
  std::vector<SiteId> births, deaths;  // rows
};

template <int D>
Diagram diagram(const Filtration<D>& filtration, const std::vector<PersistencePair>& pairs,
                std::size_t dimension) {
  Diagram result;
  const auto add = [&](SimplexId simplex, std::size_t width, std::vector<SiteId>& rows) {
    if (!simplex.exists()) {
      result.indices.push_back(filtration.never());
      result.alpha2.push_back(std::numeric_limits<double>::infinity());
      return rows.resize(rows.size() + width);
    }
    result.indices.push_back(filtration.enters(simplex));
    result.alpha2.push_back(filtration.alpha2(filtration.enters(simplex)));
    const auto of_one = filtration.rows(simplex);
    rows.insert(rows.end(), of_one.begin(), of_one.end());
  };
  for (const PersistencePair& pair : pairs) {
    add(pair.birth, dimension + 1, result.births);
    add(pair.death, dimension + 2, result.deaths);
  }
  return result;
}

nb::list persistence(const AlphaShapes& shapes, bool all, std::optional<unsigned> threads) {
  const auto wanted = all ? orthoball::WantedPairs::all : orthoball::WantedPairs::lasting;
  auto diagrams = without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    const auto pairs = orthoball::persistence_pairs<D>(filtration, wanted, threads_of(threads));
    std::vector<Diagram> all_of_them;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      all_of_them.push_back(diagram(filtration, pairs[k], k));
    }
    return all_of_them;
  });
  nb::list result;
  for (std::size_t k = 0; k < diagrams.size(); ++k) {
    const std::size_t size = diagrams[k].indices.size() / 2;
    result.append(
        nb::make_tuple(owned<double>(std::move(diagrams[k].alpha2), {size, 2}),
                       owned<std::uint32_t>(std::move(diagrams[k].indices), {size, 2}),
                       owned<std::uint32_t>(std::move(diagrams[k].births), {size, k + 1}),
                       owned<std::uint32_t>(std::move(diagrams[k].deaths), {size, k + 2})));
  }
  return result;
}

nb::tuple betti(const AlphaShapes& shapes, std::uint32_t index, std::optional<unsigned> threads) {
  const auto numbers = without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    const auto of_index = orthoball::betti_numbers<D>(filtration, index, threads_of(threads));
    return std::vector<std::uint32_t>(of_index.begin(), of_index.end());
  });
  nb::list result;
  for (const std::uint32_t number : numbers) result.append(number);
  return nb::tuple(result);
}

}  // namespace

void bind_topology(nb::module_& module) {
  module.def("betti", &betti, nb::arg("shapes"), nb::arg("index"), nb::arg("threads").none(),
             nb::sig("def betti(shapes: AlphaShapes, index: int, threads: int | None) -> "
                     "tuple[int, ...]"),
             "Betti numbers of the complex at an index, D of them.");
  module.def(
      "persistence", &persistence, nb::arg("shapes"), nb::arg("all"), nb::arg("threads").none(),
      "For every dimension k below D: alpha2 (n, 2) float64, indices (n, 2), vertices of the\n"
      "simplices that give birth (n, k + 1) and death (n, k + 2), uint32.");
}
