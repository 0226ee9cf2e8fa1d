// SPDX-License-Identifier: MIT
#include "orthoball/signatures/signature.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "orthoball/error.h"
#include "orthoball/large_blocks.h"
#include "orthoball/signatures/signature_scan.h"

namespace orthoball {
template <int D>
void scan_signatures(const Filtration<D>& filtration,
                     const std::function<void(const Signature<D>&)>& visit, Threads threads) {
  const LargeBlockReuse reuse;
  threads = threads.for_work(filtration.size(), kLeastSimplices);
  constexpr std::size_t kBlock = SignatureScan<D>::kBlock;
  constexpr std::size_t kBlocksAtOnce = 256;
  SignatureScan<D> scan(filtration, threads);
  std::vector<Signature<D>> block(kBlock);
  while (scan.next()) {
    // So many blocks that they are in a cache still when they are visited.
    const std::size_t at_once = threads.count() == 1 ? 1 : kBlocksAtOnce;
    if (block.size() < at_once * kBlock) block.resize(at_once * kBlock);
    for (std::size_t first = 0; first < scan.block_count(); first += at_once) {
      const std::size_t blocks = std::min(at_once, scan.block_count() - first);
      parallel_for(threads, blocks, [&](std::size_t i) {
        (void)scan.read(first + i, std::span(block).subspan(i * kBlock, kBlock));
      });
      const std::size_t size =
          std::min(blocks * kBlock, scan.end_index() - scan.first_index() - first * kBlock);
      for (std::size_t i = 0; i < size; ++i) {
        if (block[i].index != 0) visit(block[i]);
      }
    }
  }
}

template <int D>
std::vector<Signature<D>> signatures(const Filtration<D>& filtration,
                                     std::span<const std::uint32_t> indices, Threads threads) {
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
  SignatureScan<D> scan(filtration, threads.for_work(filtration.size(), kLeastSimplices));
  std::vector<Signature<D>> block(SignatureScan<D>::kBlock);
  std::uint32_t begin = 0, end = 0;  // of the block
  for (const std::size_t i : order) {
    while (indices[i] >= scan.end_index() && scan.next()) {
    }
    if (indices[i] >= end) {
      const std::uint32_t number = (indices[i] - scan.first_index()) / SignatureScan<D>::kBlock;
      begin = scan.first_index() + number * SignatureScan<D>::kBlock;
      end = begin + static_cast<std::uint32_t>(scan.read(number, block));
    }
    result[i] = block[indices[i] - begin];
  }
  return result;
}

template void scan_signatures<2>(const Filtration<2>&,
                                 const std::function<void(const Signature<2>&)>&, Threads);
template void scan_signatures<3>(const Filtration<3>&,
                                 const std::function<void(const Signature<3>&)>&, Threads);
template std::vector<Signature<2>> signatures<2>(const Filtration<2>&,
                                                 std::span<const std::uint32_t>, Threads);
template std::vector<Signature<3>> signatures<3>(const Filtration<3>&,
                                                 std::span<const std::uint32_t>, Threads);

}  // namespace orthoball
