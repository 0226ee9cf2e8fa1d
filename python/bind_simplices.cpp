// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/optional.h>

#include <algorithm>
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

// The rows of simplex(i), `width` places each, the rest filled with none.
template <int D, class Simplex>
Rows rows_of(const Filtration<D>& filtration, std::size_t size, std::size_t width,
             orthoball::Threads threads, const Simplex& simplex) {
  Rows rows(size * width);
  for_each(size, threads, [&](std::size_t i) {
    const auto of_one = filtration.rows(simplex(i));
    std::fill(std::copy(of_one.begin(), of_one.end(), &rows[i * width]), &rows[i * width] + width,
              SiteId());
  });
  return rows;
}

void check_dimension(const AlphaShapes& shapes, int dimension) {
  if (dimension >= 0 && dimension <= shapes.dimension()) return;
  using orthoball::InputError;
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                   fmt::format("there are no simplices of dimension {}; dimensions are 0 to {}",
                               dimension, shapes.dimension()));
}

template <int D>
nb::tuple simplices(const Filtration<D>& filtration, int dimension, nb::handle owner) {
  const std::size_t first = filtration.table().first(dimension), size = filtration.count(dimension);
  const auto width = static_cast<std::size_t>(dimension) + 1;
  const auto simplex = [=](std::size_t i) {
    return SimplexId(static_cast<std::uint32_t>(first + i));
  };
  Rows rows;
  Indices regular, interior;
  {
    const nb::gil_scoped_release released;
    const orthoball::Threads threads;
    rows = rows_of(filtration, size, width, threads, simplex);
    regular.resize(size);
    interior.resize(size);
    for_each(size, threads, [&](std::size_t i) {
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

template <int D>
nb::tuple filtration_arrays(const Filtration<D>& filtration, std::uint32_t index) {
  orthoball::RawVector<std::uint8_t> dimensions;
  Rows rows;
  orthoball::RawVector<double> alpha2;
  Indices enters, regular, interior;
  std::size_t size = 0;
  {
    const nb::gil_scoped_release released;
    const orthoball::Threads threads;
    const orthoball::Filter<D> filter(filtration, threads);
    const std::vector<SimplexId> order = filter.by_rows();
    size = filter.complex_size(index);
    for (auto* const column : {&enters, &regular, &interior}) column->resize(size);
    dimensions.resize(size);
    alpha2.resize(size);
    rows = rows_of(filtration, size, D + 1, threads, [&](std::size_t i) { return order[i]; });
    for_each(size, threads, [&](std::size_t i) {
      dimensions[i] = static_cast<std::uint8_t>(filtration.dimension(order[i]));
      enters[i] = filtration.enters(order[i]);
      regular[i] = filtration.regular(order[i]);
      interior[i] = filtration.interior(order[i]);
      alpha2[i] = filtration.alpha2(enters[i]);
    });
  }
  return nb::make_tuple(owned<std::uint8_t>(std::move(dimensions)),
                        owned<std::uint32_t>(std::move(rows), {size, std::size_t{D} + 1}),
                        owned<double>(std::move(alpha2)), owned<std::uint32_t>(std::move(enters)),
                        owned<std::uint32_t>(std::move(regular)),
                        owned<std::uint32_t>(std::move(interior)));
}

// Of every simplex of a dimension, as the number of its orthoball::Role.
Array<std::uint8_t> roles(const AlphaShapes& shapes, int dimension, std::uint32_t index) {
  check_dimension(shapes, dimension);
  auto numbers = without_gil(shapes, [&](const auto& filtration) {
    const std::size_t first = filtration.table().first(dimension);
    orthoball::RawVector<std::uint8_t> of_all(filtration.count(dimension));
    for_each(of_all.size(), orthoball::Threads(), [&](std::size_t i) {
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
      [](nb::handle self, int dimension) {
        const auto& shapes = nb::cast<const AlphaShapes&>(self);
        check_dimension(shapes, dimension);
        return std::visit(
            [&](const auto& filtration) { return simplices(filtration, dimension, self); },
            shapes.filtration());
      },
      nb::arg("shapes"), nb::arg("dimension"),
      "Of one dimension: vertices (k, dimension + 1), enters, regular, interior (k,), all uint32.");
  module.def(
      "filtration",
      [](const AlphaShapes& shapes, std::uint32_t index) {
        return std::visit([&](const auto& f) { return filtration_arrays(f, index); },
                          shapes.filtration());
      },
      nb::arg("shapes"), nb::arg("index"),
      "The complex at an index in filter order: dimension uint8, vertices (n, D + 1) uint32, "
      "alpha2\n"
      "float64, enters, regular, interior uint32.");
  module.def("roles", &roles, nb::arg("shapes"), nb::arg("dimension"), nb::arg("index"),
             "Of every simplex of a dimension, (k,) uint8: exterior, singular, regular, interior.");
}
