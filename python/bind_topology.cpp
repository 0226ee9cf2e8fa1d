// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>

#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "orthoball/output/persistence_plot.h"
#include "orthoball/output/persistence_table.h"
#include "orthoball/output/representative_files.h"
#include "orthoball/queries/representatives.h"
#include "orthoball/topology/betti.h"
#include "orthoball/topology/persistence.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/plot_axis.h"
#include "python/simplex_rows.h"
#include "python/written.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::PersistencePair;
using orthoball::PersistencePairs;
using orthoball::Representative;
using orthoball::SimplexId;
using orthoball::SiteId;

namespace {

using MaybeThreads = std::optional<unsigned>;

// What finds representatives, once somebody asks.
template <int D>
struct Finder {
  Finder(const Filtration<D>& filtration, orthoball::Threads threads)
      : all(orthoball::persistence_pairs<D>(filtration, orthoball::WantedPairs::all, threads)),
        representatives(filtration, all) {}

  PersistencePairs<D> all;
  orthoball::Representatives<D> representatives;
};

template <int D>
struct PairsOf {
  const Filtration<D>* filtration;
  PersistencePairs<D> wanted;
  std::unique_ptr<Finder<D>> finder{};

  // Those of one dimension, or of all.
  [[nodiscard]] PersistencePairs<D> of_dimension(std::optional<std::size_t> dimension) const {
    if (!dimension) return wanted;
    PersistencePairs<D> some;
    some[*dimension] = wanted[*dimension];
    return some;
  }
};

// The pairs of a family, which outlives them. Any number of threads may use it.
struct Pairs {
  const AlphaShapes* shapes;
  std::variant<PairsOf<2>, PairsOf<3>> of;
  std::mutex while_finding{};
};

template <class Visit>
auto visited(const Pairs& pairs, const Visit& visit) {
  return std::visit(visit, pairs.of);
}

std::unique_ptr<Pairs> persistence_pairs(const AlphaShapes& shapes, bool all, double minimum_length,
                                         MaybeThreads threads) {
  const auto wanted = all ? orthoball::WantedPairs::all : orthoball::WantedPairs::lasting;
  return without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    auto pairs = orthoball::persistence_pairs<D>(filtration, wanted, threads_of(threads));
    if (minimum_length > 0.0) {
      pairs = orthoball::pairs_of_length<D>(filtration, std::move(pairs), minimum_length);
    }
    std::unique_ptr<Pairs> result(new Pairs{&shapes, PairsOf<D>{&filtration, std::move(pairs)}});
    return result;
  });
}

// What Python gets of the pairs of one dimension.
struct Diagram {
  std::vector<std::uint32_t> indices;  // 2 a pair
  std::vector<double> alpha2;          // 2 a pair
  std::vector<SiteId> births, deaths;  // rows
};

template <int D>
Diagram diagram(const PairsOf<D>& pairs, std::size_t dimension) {
  const Filtration<D>& filtration = *pairs.filtration;
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
  for (const PersistencePair& pair : pairs.wanted[dimension]) {
    add(pair.birth, dimension + 1, result.births);
    add(pair.death, dimension + 2, result.deaths);
  }
  return result;
}

nb::tuple diagram_arrays(const Pairs& self, std::size_t dimension) {
  Diagram found = [&] {
    const nb::gil_scoped_release released;
    return visited(self, [&](const auto& pairs) { return diagram(pairs, dimension); });
  }();
  const std::size_t size = found.indices.size() / 2;
  return nb::make_tuple(owned<double>(std::move(found.alpha2), {size, 2}),
                        owned<std::uint32_t>(std::move(found.indices), {size, 2}),
                        owned<std::uint32_t>(std::move(found.births), {size, dimension + 1}),
                        owned<std::uint32_t>(std::move(found.deaths), {size, dimension + 2}));
}

nb::bytes pairs_file(const Pairs& self, std::optional<std::size_t> dimension,
                     const std::string& format, bool indices) {
  if (format != "csv" && format != "json" && format != "gudhi") {
    refuse_format(format, "csv, json and gudhi");
  }
  const auto values =
      indices ? orthoball::PersistenceValues::index : orthoball::PersistenceValues::alpha2;
  return written(format == "json" ? "null" : "", [&](orthoball::ByteSink& sink) {
    visited(self, [&]<int D>(const PairsOf<D>& pairs) {
      const auto some = pairs.of_dimension(dimension);
      if (format == "csv") write_persistence_csv<D>(sink, *pairs.filtration, some, values);
      if (format == "json") write_persistence_json<D>(sink, *pairs.filtration, some, values);
      if (format == "gudhi") write_persistence_gudhi<D>(sink, *pairs.filtration, some, values);
    });
  });
}

nb::bytes pairs_figure(const Pairs& self, std::optional<std::size_t> dimension,
                       const std::string& kind, const std::string& axis, const std::string& title,
                       const std::string& subtitle, const std::string& unit) {
  if (kind != "diagram" && kind != "barcode") {
    refuse("the kind is \"" + kind + "\"; it is \"diagram\" or \"barcode\"");
  }
  orthoball::PersistencePlotOptions options;
  options.title = title;
  options.subtitle = subtitle;
  options.unit = unit;
  options.axis = plot_axis(axis);
  options.picture = kind == "barcode" ? orthoball::PersistencePicture::barcode
                                      : orthoball::PersistencePicture::diagram;
  return written("0", [&](orthoball::ByteSink& sink) {
    visited(self, [&]<int D>(const PairsOf<D>& pairs) {
      write_persistence_plot<D>(sink, *pairs.filtration, pairs.of_dimension(dimension), options);
    });
  });
}

// What makes some classes of a family, which outlives it.
struct Found {
  const AlphaShapes* shapes;
  std::vector<Representative> all;
};

// What is asked for: a class or all of a dimension or of all, at an index or where it is best seen.
struct Wanted {
  std::optional<std::size_t> dimension, number;
  std::optional<std::uint32_t> index;
};

template <int D>
std::vector<Representative> representatives(PairsOf<D>& pairs, const Wanted& wanted,
                                            orthoball::Threads threads) {
  const Filtration<D>& filtration = *pairs.filtration;
  if (!pairs.finder) pairs.finder = std::make_unique<Finder<D>>(filtration, threads);
  std::vector<Representative> found;
  for (std::size_t k = 0; k < D; ++k) {
    if (wanted.dimension && *wanted.dimension != k) continue;
    for (std::size_t i = 0; i < pairs.wanted[k].size(); ++i) {
      if (wanted.number && *wanted.number != i) continue;
      const PersistencePair& pair = pairs.wanted[k][i];
      const int dimension = static_cast<int>(k);
      const std::uint32_t index =
          wanted.index ? *wanted.index : pairs.finder->representatives.usual_index(dimension, pair);
      const bool is_over = pair.death.exists() && filtration.enters(pair.death) <= index;
      // One that is asked for by number is refused where it does not live.
      if (!wanted.number && (is_over || filtration.enters(pair.birth) > index)) continue;
      found.push_back(pairs.finder->representatives.at(dimension, pair, index));
    }
  }
  return found;
}

Found found_representatives(Pairs& self, std::optional<std::size_t> dimension,
                            std::optional<std::size_t> number, std::optional<std::uint32_t> index,
                            MaybeThreads threads) {
  const nb::gil_scoped_release released;
  const std::lock_guard lock(self.while_finding);
  return {self.shapes,
          std::visit(
              [&](auto& pairs) {
                return representatives(pairs, {dimension, number, index}, threads_of(threads));
              },
              self.of)};
}

template <int D>
nb::dict as_dict(const Filtration<D>& filtration, const Representative& one) {
  const auto simplex = [&](SimplexId id) -> nb::object {
    if (!id.exists()) return nb::none();
    const auto rows = filtration.rows(id);
    return nb::cast(owned<std::uint32_t>(std::vector<SiteId>(rows.begin(), rows.end())));
  };
  const auto label = [&](SimplexId id) {
    return id.exists() ? filtration.alpha2(filtration.enters(id))
                       : std::numeric_limits<double>::infinity();
  };
  nb::list rings;
  for (const auto& ring : one.rings) {
    rings.append(owned<std::uint32_t>(std::vector<SiteId>(ring)));
  }
  nb::dict result;
  result["dimension"] = one.dimension;
  result["birth"] = label(one.pair.birth);
  result["death"] = label(one.pair.death);
  result["index"] = one.index;
  result["alpha2"] = filtration.alpha2(one.index);
  result["rows"] = owned<std::uint32_t>(std::vector<SiteId>(one.rows));
  result["cycle"] = rows_of(filtration, one.cycle, static_cast<std::size_t>(one.dimension) + 1);
  result["rings"] = nb::tuple(rings);
  result["cells"] = rows_of(filtration, one.cells, std::size_t{D} + 1);
  result["size"] = one.size;
  result["volume"] = one.volume;
  result["birth_simplex"] = simplex(one.pair.birth);
  result["death_simplex"] = simplex(one.pair.death);
  return result;
}

nb::list found_list(const Found& self) {
  nb::list result;
  std::visit(
      [&](const auto& filtration) {
        for (const Representative& one : self.all) result.append(as_dict(filtration, one));
      },
      self.shapes->filtration());
  return result;
}

nb::bytes found_file(const Found& self, const std::string& format) {
  if (format != "json" && format != "ply") refuse_format(format, "json and ply");
  return written("null", [&](orthoball::ByteSink& sink) {
    std::visit(
        [&]<int D>(const Filtration<D>& filtration) {
          if (format == "ply") {
            return write_representatives_ply<D>(sink, filtration, self.shapes->points(), self.all);
          }
          write_representatives_json<D>(sink, filtration, self.all);
        },
        self.shapes->filtration());
  });
}

nb::tuple betti(const AlphaShapes& shapes, std::uint32_t index, MaybeThreads threads) {
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
  nb::class_<Found>(module, "FoundRepresentatives", "See orthoball.Representatives.")
      .def("list", &found_list, "A dict each.")
      .def("file", &found_file, nb::arg("format"), "json or ply.");
  nb::class_<Pairs>(module, "PersistencePairs", "See orthoball.Diagrams.")
      .def("arrays", &diagram_arrays, nb::arg("dimension"),
           "Of one dimension k: alpha2 (n, 2) float64, indices (n, 2), vertices of the simplices\n"
           "that give birth (n, k + 1) and death (n, k + 2), uint32.")
      .def("file", &pairs_file, nb::arg("dimension").none(), nb::arg("format"), nb::arg("indices"),
           "Those of one dimension, or all: csv, json or gudhi.")
      .def("figure", &pairs_figure, nb::arg("dimension").none(), nb::arg("kind"), nb::arg("axis"),
           nb::arg("title"), nb::arg("subtitle"), nb::arg("unit"), "The same as SVG.")
      .def("representatives", &found_representatives, nb::arg("dimension").none(),
           nb::arg("number").none(), nb::arg("index").none(), nb::arg("threads").none(),
           nb::keep_alive<0, 1>(), "What makes a class, or all that live at an index.");
  module.def("persistence_pairs", &persistence_pairs, nb::arg("shapes"), nb::arg("all"),
             nb::arg("minimum_length"), nb::arg("threads").none(), nb::keep_alive<0, 1>(),
             "The persistence pairs of all dimensions.");
}
