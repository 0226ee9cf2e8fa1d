// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filter_columns.h"
#include "orthoball/output/tables.h"
#include "orthoball/raw_vector.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/written.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::SimplexId;
using orthoball::SiteId;

namespace {

constexpr std::size_t kLeastPart = std::size_t{1} << 14U;  // simplices for a thread of its own

// Calls `write(i)` for 0..size - 1, in parts on as many threads as are worth it.
template <class Write>
void for_each(std::size_t size, orthoball::Threads threads, const Write& write) {
  const orthoball::Threads used = threads.for_work(size, kLeastPart);
  orthoball::parallel_parts(used, size, used.count(),
                            [&](std::size_t, std::size_t begin, std::size_t end) {
                              for (std::size_t i = begin; i < end; ++i) write(i);
                            });
}

using Rows = orthoball::RawVector<SiteId>;
using Indices = orthoball::RawVector<std::uint32_t>;

void check_dimension(const AlphaShapes& shapes, int dimension) {
  if (dimension >= 0 && dimension <= shapes.dimension()) return;
  refuse(fmt::format("there are no simplices of dimension {}; dimensions are 0 to {}", dimension,
                     shapes.dimension()));
}

template <int D>
nb::tuple simplices(const Filtration<D>& filtration, int dimension, nb::handle owner,
                    orthoball::Threads threads) {
  const std::size_t first = filtration.table().first(dimension), size = filtration.count(dimension);
  const auto width = static_cast<std::size_t>(dimension) + 1;
  const auto simplex = [=](std::size_t i) {
    return SimplexId(static_cast<std::uint32_t>(first + i));
  };
  Rows rows;
  Indices regular, interior;
  {
    const nb::gil_scoped_release released;
    rows.resize(size * width);
    regular.resize(size);
    interior.resize(size);
    for_each(size, threads, [&](std::size_t i) {
      const auto of_one = filtration.rows(simplex(i));
      std::copy(of_one.begin(), of_one.end(), &rows[i * width]);
      regular[i] = filtration.regular(simplex(i));
      interior[i] = filtration.interior(simplex(i));
    });
  }
  const auto enters = filtration.enters().subspan(first, size);
  return nb::make_tuple(owned<std::uint32_t>(std::move(rows), {size, width}),
                        view<std::uint32_t>(enters, owner, {size}),
                        owned<std::uint32_t>(std::move(regular)),
                        owned<std::uint32_t>(std::move(interior)));
}

// The columns of a filter; of shapes that outlive them.
struct FilterArrays {
  const AlphaShapes* shapes;
  std::uint32_t index;
  std::variant<orthoball::FilterColumns<2>, orthoball::FilterColumns<3>> columns;
};

FilterArrays filter_arrays(const AlphaShapes& shapes, std::uint32_t index,
                           std::optional<unsigned> threads) {
  return without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    return FilterArrays{&shapes, index,
                        orthoball::FilterColumns<D>(filtration, index, threads_of(threads))};
  });
}

nb::bytes filter_file(const FilterArrays& self, const std::string& format,
                      std::optional<unsigned> threads) {
  if (format != "csv" && format != "json" && format != "npz") {
    refuse_format(format, "csv, json and npz");
  }
  return written(format == "json" ? "null" : "", [&](orthoball::ByteSink& sink) {
    std::visit(
        [&]<int D>(const Filtration<D>& filtration) {
          const orthoball::Filter<D> filter(filtration, threads_of(threads));
          const std::size_t count = filter.complex_size(self.index);
          if (format == "csv") write_filter_csv(sink, filter, count);
          if (format == "json") write_filter_json_lines(sink, filter, count);
          if (format == "npz") write_filter_npz(sink, filter, count);
        },
        self.shapes->filtration());
  });
}

// A column that is there: what `column` gives, `width(D)` numbers a simplex.
template <class T, class Column, class Width>
Array<T> column_view(nb::handle self, const Column& column, const Width& width) {
  return std::visit(
      [&]<int D>(const orthoball::FilterColumns<D>& columns) {
        const std::size_t wide = width(D);
        if (wide == 1) return view<T>(column(columns), self, {columns.size()});
        return view<T>(column(columns), self, {columns.size(), wide});
      },
      nb::cast<const FilterArrays&>(self).columns);
}

// A column that is made.
template <class T, class Make>
Array<T> made_column(const FilterArrays& self, const Make& make) {
  auto numbers = [&] {
    const nb::gil_scoped_release released;
    return std::visit(make, self.columns);
  }();
  return owned<T>(std::move(numbers));
}

void bind_filter(nb::module_& module) {
  const auto one = [](int) { return std::size_t{1}; };
  nb::class_<FilterArrays>(module, "FilterColumns", "A complex in filter order, as columns.")
      .def_prop_ro(
          "dimension",
          [one](nb::handle self) {
            return column_view<std::uint8_t>(
                self, [](const auto& columns) { return columns.dimensions(); }, one);
          },
          nb::sig("def dimension(self) -> numpy.typing.NDArray[numpy.uint8]"), "(n,)")
      .def_prop_ro(
          "vertices",
          [](nb::handle self) {
            return column_view<std::uint32_t>(
                self, [](const auto& columns) { return columns.rows(); },
                [](int dimension) { return static_cast<std::size_t>(dimension) + 1; });
          },
          nb::sig("def vertices(self) -> numpy.typing.NDArray[numpy.uint32]"), "(n, D + 1)")
      .def_prop_ro(
          "enters",
          [one](nb::handle self) {
            return column_view<std::uint32_t>(
                self, [](const auto& columns) { return columns.enters(); }, one);
          },
          nb::sig("def enters(self) -> numpy.typing.NDArray[numpy.uint32]"), "(n,)")
      .def(
          "alpha2",
          [](const FilterArrays& self, std::optional<unsigned> threads) {
            return made_column<double>(
                self, [&](const auto& columns) { return columns.alpha2(threads_of(threads)); });
          },
          nb::arg("threads").none(), "(n,) float64.")
      .def(
          "regular",
          [](const FilterArrays& self, std::optional<unsigned> threads) {
            return made_column<std::uint32_t>(
                self, [&](const auto& columns) { return columns.regular(threads_of(threads)); });
          },
          nb::arg("threads").none(), "(n,) uint32.")
      .def(
          "interior",
          [](const FilterArrays& self, std::optional<unsigned> threads) {
            return made_column<std::uint32_t>(
                self, [&](const auto& columns) { return columns.interior(threads_of(threads)); });
          },
          nb::arg("threads").none(), "(n,) uint32.")
      .def("file", &filter_file, nb::arg("format"), nb::arg("threads").none(),
           "As a table: csv, json (an object a line) or npz.");
  module.def("filtration", &filter_arrays, nb::arg("shapes"), nb::arg("index"),
             nb::arg("threads").none(), nb::keep_alive<0, 1>(),
             "The complex at an index in filter order.");
}

// Of every simplex of a dimension, as the number of its orthoball::Role.
Array<std::uint8_t> roles(const AlphaShapes& shapes, int dimension, std::uint32_t index,
                          std::optional<unsigned> threads) {
  check_dimension(shapes, dimension);
  auto numbers = without_gil(shapes, [&](const auto& filtration) {
    const std::size_t first = filtration.table().first(dimension);
    orthoball::RawVector<std::uint8_t> of_all(filtration.count(dimension));
    for_each(of_all.size(), threads_of(threads), [&](std::size_t i) {
      const SimplexId simplex(static_cast<std::uint32_t>(first + i));
      of_all[i] = static_cast<std::uint8_t>(filtration.role(simplex, index));
    });
    return of_all;
  });
  return owned<std::uint8_t>(std::move(numbers));
}

}  // namespace

void bind_simplices(nb::module_& module) {
  module.def(
      "simplices",
      [](nb::handle self, int dimension, std::optional<unsigned> threads) {
        const auto& shapes = nb::cast<const AlphaShapes&>(self);
        check_dimension(shapes, dimension);
        return std::visit(
            [&](const auto& filtration) {
              return simplices(filtration, dimension, self, threads_of(threads));
            },
            shapes.filtration());
      },
      nb::arg("shapes"), nb::arg("dimension"), nb::arg("threads").none(),
      "Of one dimension: vertices (k, dimension + 1), enters, regular, interior (k,), all uint32.");
  bind_filter(module);
  module.def("roles", &roles, nb::arg("shapes"), nb::arg("dimension"), nb::arg("index"),
             nb::arg("threads").none(),
             "Of every simplex of a dimension, (k,) uint8: exterior, singular, regular, interior.");
}
