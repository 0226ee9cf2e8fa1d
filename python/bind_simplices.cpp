// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <array>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/raw_vector.h"
#include "python/arrays.h"
#include "python/module.h"

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
  using orthoball::InputError;
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                   fmt::format("there are no simplices of dimension {}; dimensions are 0 to {}",
                               dimension, shapes.dimension()));
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

// The columns of a filter, by position.
struct FilterColumns {
  explicit FilterColumns(std::size_t size, std::size_t width)
      : dimensions(size),
        rows(size * width),
        alpha2(size),
        enters(size),
        regular(size),
        interior(size) {}

  orthoball::RawVector<std::uint8_t> dimensions;
  Rows rows;  // [width * position + i]
  orthoball::RawVector<double> alpha2;
  Indices enters, regular, interior;
};

// All of one simplex, so that it is written to one place.
template <int D>
struct FilterRow {
  std::array<SiteId, std::size_t{D} + 1> rows;
  std::uint32_t enters, regular, interior, dimension;
};

// Simplices are visited as they lie in memory and written where they belong, which is faster than
// the other way round; then rows become columns.
template <int D>
FilterColumns filter_columns(const Filtration<D>& filtration, std::uint32_t index,
                             orthoball::Threads threads) {
  const orthoball::Filter<D> filter(filtration, threads);
  const std::size_t size = filter.complex_size(index);
  Indices position(filtration.size());
  {
    const std::vector<SimplexId> order = filter.by_rows();
    for_each(order.size(), threads,
             [&](std::size_t i) { position[order[i].row()] = static_cast<std::uint32_t>(i); });
  }
  orthoball::RawVector<FilterRow<D>> table(size);
  for (int dimension = 0; dimension <= D; ++dimension) {
    const std::size_t first = filtration.table().first(dimension);
    for_each(filtration.count(dimension), threads, [&](std::size_t i) {
      const SimplexId simplex(static_cast<std::uint32_t>(first + i));
      const std::size_t at = position[simplex.row()];
      if (at >= size) return;
      FilterRow<D> row{{},
                       filtration.enters(simplex),
                       filtration.regular(simplex),
                       filtration.interior(simplex),
                       static_cast<std::uint32_t>(dimension)};
      const auto rows = filtration.rows(simplex);
      std::copy(rows.begin(), rows.end(), row.rows.begin());
      table[at] = row;
    });
  }
  FilterColumns columns(size, D + 1);
  for_each(size, threads, [&](std::size_t i) {
    const FilterRow<D>& row = table[i];
    std::copy(row.rows.begin(), row.rows.end(), &columns.rows[(D + 1) * i]);
    columns.dimensions[i] = static_cast<std::uint8_t>(row.dimension);
    columns.enters[i] = row.enters;
    columns.regular[i] = row.regular;
    columns.interior[i] = row.interior;
    columns.alpha2[i] = filtration.alpha2(row.enters);
  });
  return columns;
}

template <int D>
nb::tuple filtration_arrays(const Filtration<D>& filtration, std::uint32_t index,
                            orthoball::Threads threads) {
  FilterColumns columns = [&] {
    const nb::gil_scoped_release released;
    return filter_columns(filtration, index, threads);
  }();
  const std::size_t size = columns.alpha2.size();
  return nb::make_tuple(owned<std::uint8_t>(std::move(columns.dimensions)),
                        owned<std::uint32_t>(std::move(columns.rows), {size, std::size_t{D} + 1}),
                        owned<double>(std::move(columns.alpha2)),
                        owned<std::uint32_t>(std::move(columns.enters)),
                        owned<std::uint32_t>(std::move(columns.regular)),
                        owned<std::uint32_t>(std::move(columns.interior)));
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
  module.def(
      "filtration",
      [](const AlphaShapes& shapes, std::uint32_t index, std::optional<unsigned> threads) {
        return std::visit(
            [&](const auto& f) { return filtration_arrays(f, index, threads_of(threads)); },
            shapes.filtration());
      },
      nb::arg("shapes"), nb::arg("index"), nb::arg("threads").none(),
      "The complex at an index in filter order: dimension uint8, vertices (n, D + 1) uint32, "
      "alpha2\n"
      "float64, enters, regular, interior uint32.");
  module.def("roles", &roles, nb::arg("shapes"), nb::arg("dimension"), nb::arg("index"),
             nb::arg("threads").none(),
             "Of every simplex of a dimension, (k,) uint8: exterior, singular, regular, interior.");
}
