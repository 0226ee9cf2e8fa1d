// SPDX-License-Identifier: MIT
//
// What changes at each index is counted stretch by stretch, most of it by the scan of the measures.
// Blocks of indices begin with what their predecessors add up to, so that they can be written at
// the same time.
#include "orthoball/signatures/signature_scan.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace orthoball {

template <int D>
SignatureScan<D>::SignatureScan(const Filtration<D>& filtration, Threads threads)
    : filtration_(filtration),
      threads_(threads),
      roles_(filtration, threads),
      measures_(filtration, roles_, threads),
      end_{RoleCounts<D>(filtration)} {
  voids_ = void_counts(filtration, roles_, threads);
  joining_ = joining_counts(filtration, threads);
  for (std::size_t k = 0; k < lower_.size(); ++k) {
    lower_[k] = {filtration, static_cast<int>(k), threads};
  }
  vertices_ = index_counts(filtration.spectrum_size(), filtration.count(0), threads,
                           [&](std::size_t i) { return filtration.enters()[i]; });
}

template <int D>
void SignatureScan<D>::count_changes() {
  const std::uint32_t first_stretch = first_index() >> kIndexStretchBits;
  const std::size_t stretches = (end_index() - first_index() - 1) / kIndexStretch + 1;
  std::vector<std::pair<const IndexCounts*, Column*>> counted{{&vertices_, &own_.vertices},
                                                              {&joining_, &own_.joining}};
  if constexpr (D == 3) {
    counted.push_back({&voids_.opening, &own_.opening});
    counted.push_back({&voids_.closing, &own_.closing});
  }
  for (std::size_t k = 0; k < lower_.size(); ++k) {
    counted.push_back({&lower_[k].regular, &own_.regular[k]});
    counted.push_back({&lower_[k].interior, &own_.interior[k]});
  }
  for (const auto& [counts, column] : counted) column->resize(stretches * kIndexStretch);

  changes_.entering[0] = own_.vertices.data();
  for (int k = 1; k <= D; ++k) {
    changes_.entering[static_cast<std::size_t>(k)] = measures_.entering(k).data();
  }
  for (std::size_t k = 0; k < lower_.size(); ++k) {
    changes_.regular[k] = own_.regular[k].data();
    changes_.interior[k] = own_.interior[k].data();
  }
  changes_.interior[D - 1] = measures_.becoming_interior().data();
  changes_.joining = own_.joining.data();
  changes_.opening = own_.opening.data();
  changes_.closing = own_.closing.data();

  const std::size_t size = end_index() - first_index();
  steps_.resize((size - 1) / kBlock + 1);
  parallel_for(threads_, stretches, [&](std::size_t i) {
    for (const auto& [counts, column] : counted) {
      counts->count_stretch(first_stretch + static_cast<std::uint32_t>(i),
                            std::span(*column).subspan(i * kIndexStretch, kIndexStretch));
    }
    constexpr std::size_t kBlocks = kIndexStretch / kBlock;
    const std::size_t end_block = std::min((i + 1) * kBlocks, steps_.size());
    for (std::size_t block = i * kBlocks; block < end_block; ++block) {
      const std::size_t begin = block * kBlock;
      const std::size_t end = std::min<std::size_t>(begin + kBlock, size);
      steps_[block] = changes_.step([&](const std::uint32_t* column) {
        return std::accumulate(column + begin, column + end, std::uint32_t{0});
      });
    }
  });
}

template <int D>
bool SignatureScan<D>::next() {
  if (!measures_.next()) return false;
  count_changes();
  blocks_.clear();
  for (const Step& step : steps_) {
    blocks_.push_back(end_);
    end_.advance(step);
  }
  return true;
}

template <int D>
std::size_t SignatureScan<D>::read(std::size_t block, std::span<Signature<D>> out) const {
  const auto begin = static_cast<std::uint32_t>(block * kBlock);
  const std::size_t size = std::min(kBlock, end_index() - first_index() - begin);
  State state = blocks_[block];
  std::array<typename MeasureScan<D>::FacetCounts, kBlock> facets;
  std::array<ComplexMeasures, kBlock> measures;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = begin + i;
    state.advance(changes_.step([&](const std::uint32_t* column) { return column[place]; }));
    Signature<D>& signature = out[i];
    signature.index = first_index() + begin + static_cast<std::uint32_t>(i);
    signature.betti = betti_numbers<D>(state.roles.entered(), state.joined, state.voids);
    signature.euler = state.roles.euler();
    signature.exterior = state.roles.exterior();
    signature.singular = state.roles.singular();
    signature.regular = state.roles.regular();
    signature.interior = state.roles.interior();
    facets[i] = {signature.singular[D - 1], signature.regular[D - 1]};
  }
  measures_.measures(first_index() + begin, std::span(facets).first(size),
                     std::span(measures).first(size));
  for (std::size_t i = 0; i < size; ++i) {
    Signature<D>& signature = out[i];
    signature.alpha2 = signature.index == 0 ? -std::numeric_limits<double>::infinity()
                                            : filtration_.alpha2(signature.index);
    signature.volume = measures[i].volume;
    signature.area_singular = measures[i].area_singular;
    signature.area_regular = measures[i].area_regular;
    signature.area = measures[i].area;
    signature.length = measures[i].length;
  }
  return size;
}

template class SignatureScan<2>;
template class SignatureScan<3>;

}  // namespace orthoball
