// SPDX-License-Identifier: MIT
//
// One pass over the indices. What a simplex adds when it enters comes from the filter, step by
// step; when simplices become regular or interior comes from histograms over the indices; the
// Betti numbers come from a mark per simplex, made before.
#include "orthoball/signatures/signature.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

#include "orthoball/error.h"
#include "orthoball/filtration/filter_steps.h"
#include "orthoball/measures/complex_measures.h"
#include "orthoball/signatures/role_counts.h"
#include "orthoball/topology/betti.h"

namespace orthoball {
namespace {

// The state of a scan, and the signature at the index it has come to.
template <int D>
class SignatureScan {
 public:
  explicit SignatureScan(const Filtration<D>& filtration)
      : filtration_(filtration),
        betti_(filtration),
        steps_(filtration),
        roles_(filtration),
        measures_(filtration) {}

  bool next() {
    if (!steps_.next()) return false;
    const ByDimension<D>& entering = steps_.entering();
    roles_.advance(entering);
    betti_.advance(entering);
    measures_.advance(entering);
    return true;
  }

  void read(Signature<D>& signature) {
    signature.index = steps_.index();
    signature.alpha2 = signature.index == 0 ? -std::numeric_limits<double>::infinity()
                                            : filtration_.alpha2(signature.index);
    signature.betti = betti_.betti();
    signature.euler = roles_.euler();
    signature.exterior = roles_.exterior();
    signature.singular = roles_.singular();
    signature.regular = roles_.regular();
    signature.interior = roles_.interior();
    const ComplexMeasures& measures = measures_.measures();
    signature.volume = measures.volume;
    signature.area_singular = measures.area_singular;
    signature.area_regular = measures.area_regular;
    signature.area = measures.area;
    signature.length = measures.length;
  }

 private:
  const Filtration<D>& filtration_;
  BettiScan<D> betti_;
  FilterSteps<D> steps_;
  RoleCounts<D> roles_;
  MeasureScan<D> measures_;
};

}  // namespace

template <int D>
void scan_signatures(const Filtration<D>& filtration,
                     const std::function<void(const Signature<D>&)>& visit) {
  SignatureScan<D> scan(filtration);
  Signature<D> signature;
  while (scan.next()) {
    scan.read(signature);
    visit(signature);
  }
}

template <int D>
std::vector<Signature<D>> signatures(const Filtration<D>& filtration,
                                     std::span<const std::uint32_t> indices) {
  for (const std::uint32_t index : indices) {
    if (index <= filtration.spectrum_size()) continue;
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "index " + std::to_string(index) +
                         " is beyond the spectrum; indices are 0 to " +
                         std::to_string(filtration.spectrum_size()));
  }
  std::vector<std::size_t> order(indices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return indices[a] < indices[b]; });
  std::vector<Signature<D>> result(indices.size());
  if (indices.empty()) return result;
  SignatureScan<D> scan(filtration);
  std::uint32_t reached = 0;
  for (const std::size_t i : order) {
    for (; reached < indices[i]; ++reached) scan.next();
    scan.read(result[i]);
  }
  return result;
}

template void scan_signatures<2>(const Filtration<2>&,
                                 const std::function<void(const Signature<2>&)>&);
template void scan_signatures<3>(const Filtration<3>&,
                                 const std::function<void(const Signature<3>&)>&);
template std::vector<Signature<2>> signatures<2>(const Filtration<2>&,
                                                 std::span<const std::uint32_t>);
template std::vector<Signature<3>> signatures<3>(const Filtration<3>&,
                                                 std::span<const std::uint32_t>);

}  // namespace orthoball
