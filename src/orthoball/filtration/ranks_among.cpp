// SPDX-License-Identifier: MIT
#include "orthoball/filtration/ranks_among.h"

#include <cstddef>

#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/simplex_labels.h"
#include "orthoball/filtration/simplex_reader.h"

namespace orthoball {
namespace {

// How many of the values are less; which of two halves that is in is hard to foretell.
std::uint32_t count_less(std::span<const double> values, double label) {
  const double* begin = values.data();
  for (std::size_t size = values.size(); size > 0;) {
    const std::size_t half = size - size / 2;
    const std::size_t is_less = begin[half - 1] < label ? 1 : 0;
    begin += half * is_less;
    size = (size - half) | ((half - 1) & (is_less - 1));
  }
  return static_cast<std::uint32_t>(begin - values.data());
}

}  // namespace

template <int D>
void ranks_among(std::span<const double> values, const RegularTriangulation<D>& triangulation,
                 const SimplexTable<D>& table, std::span<const std::uint64_t> is_attached,
                 std::span<std::uint32_t> ranks, Threads threads) {
  constexpr std::size_t kPart = std::size_t{1} << 15U;
  const auto of_dimension = [&]<int A, int K>() {
    SimplexReader<D, A> reader{{}, table};
    if constexpr (A >= 1) reader.cells = triangulation.template cells<A>();
    const std::size_t count = table.count(K);
    parallel_parts(
        threads, count, count / kPart + 1, [&](std::size_t, std::size_t begin, std::size_t end) {
          for_each_label<K>(triangulation.sites(), reader, is_attached,
                            static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                            [&](std::uint32_t simplex, double label) {
                              ranks[simplex] = count_less(values, label) + 1;
                            });
        });
  };
  with_affine_dimension(triangulation, [&]<int A>() {
    of_dimension.template operator()<A, 0>();
    if constexpr (A >= 1) of_dimension.template operator()<A, 1>();
    if constexpr (A >= 2) of_dimension.template operator()<A, 2>();
    if constexpr (A >= 3) of_dimension.template operator()<A, 3>();
  });
}

template void ranks_among<2>(std::span<const double>, const RegularTriangulation<2>&,
                             const SimplexTable<2>&, std::span<const std::uint64_t>,
                             std::span<std::uint32_t>, Threads);
template void ranks_among<3>(std::span<const double>, const RegularTriangulation<3>&,
                             const SimplexTable<3>&, std::span<const std::uint64_t>,
                             std::span<std::uint32_t>, Threads);

}  // namespace orthoball
