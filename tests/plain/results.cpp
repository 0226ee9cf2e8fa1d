// SPDX-License-Identifier: MIT
// A line for each family of points: digests of its triangulation, filtration and signatures, bit by
// bit. The same program with and without vector code must print the same.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <span>
#include <string>
#include <utility>

#include "generators/point_families.h"
#include "oracles/sha256.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"

namespace {

using namespace orthoball;

// Bytes in the order in which they are given, to be digested as a whole.
class Bytes {
 public:
  template <class T>
  void add(std::span<const T> numbers) {
    for (const T& number : numbers) add(number);
  }
  template <class T>
  void add(const T& number) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double>);
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    text_.append(bytes, sizeof number);
  }
  [[nodiscard]] std::string digest() const { return oracles::sha256(text_).substr(0, 16); }

 private:
  std::string text_;
};

template <int A, int D>
void add_cells(const RegularTriangulation<D>& triangulation, Bytes& bytes) {
  for (const CellRecord<A>& cell : triangulation.template cells<A>()) {
    bytes.add(std::span<const std::uint32_t>(cell.corners));
    bytes.add(std::span<const std::uint32_t>(cell.neighbours));
  }
}

template <int D>
std::string triangulation_digest(const RegularTriangulation<D>& triangulation) {
  Bytes bytes;
  for (std::uint32_t vertex = 0; vertex < triangulation.vertex_count(); ++vertex) {
    bytes.add(triangulation.sites().row(vertex).row());
  }
  for (const SiteId row : triangulation.hidden()) bytes.add(row.row());
  add_cells<1>(triangulation, bytes);
  add_cells<2>(triangulation, bytes);
  if constexpr (D == 3) add_cells<3>(triangulation, bytes);
  return bytes.digest();
}

template <int D>
std::string filtration_digest(const Filtration<D>& filtration) {
  Bytes bytes;
  const Filter<D> filter(filtration);
  bytes.add(filtration.spectrum());
  for (const SimplexId simplex : filter.simplices()) {
    bytes.add(simplex.row());
    bytes.add(std::uint32_t{filtration.is_attached(simplex)});
    bytes.add(filtration.enters(simplex));
    bytes.add(filtration.regular(simplex));
    bytes.add(filtration.interior(simplex));
  }
  return bytes.digest();
}

template <int D>
std::string signature_digest(const Filtration<D>& filtration) {
  Bytes bytes;
  scan_signatures<D>(filtration, [&](const Signature<D>& signature) {
    bytes.add(std::span<const std::uint32_t>(signature.betti));
    bytes.add(signature.volume);
    bytes.add(signature.area_singular);
    bytes.add(signature.area_regular);
    bytes.add(signature.length);
  });
  return bytes.digest();
}

template <int D>
void print(generators::PointFamily family, std::size_t count) {
  RegularTriangulation<D> triangulation =
      regular_triangulation<D>(generators::points_of(family, D, count, /*seed=*/1));
  std::cout << name(family) << ' ' << D << "D: " << triangulation_digest(triangulation);
  const Filtration<D> filtration(std::move(triangulation));
  std::cout << ' ' << filtration_digest(filtration) << ' ' << signature_digest(filtration) << '\n';
}

}  // namespace

int main() {
  for (const generators::PointFamily family : generators::point_families()) {
    const std::size_t count = is_extreme(family) ? 60 : 1500;
    print<2>(family, count);
    print<3>(family, count);
  }
}
