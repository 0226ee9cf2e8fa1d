// SPDX-License-Identifier: MIT
#include "orthoball/filtration/label_buckets.h"

#include <algorithm>

namespace orthoball {
namespace {

constexpr std::size_t kLabelsPerBucket = 8192;  // 96 KiB, and as much to sort them

}  // namespace

LabelBuckets::LabelBuckets(std::size_t most, std::span<const double> sample) : shares_(4096) {
  const std::size_t buckets = std::clamp<std::size_t>(most / kLabelsPerBucket, 1, 0xFFFF);
  for (const double label : sample) ++shares_[ordered_key(label) >> 52U].within;
  const std::uint64_t whole = (buckets << kFractionBits) - 1;
  const std::uint64_t size = std::max<std::uint64_t>(sample.size(), 1);
  std::uint64_t below = 0;
  for (Share& share : shares_) {
    const std::uint64_t next = below + share.within;
    share.below = static_cast<std::uint32_t>(below * whole / size);
    share.within = static_cast<std::uint32_t>(next * whole / size) - share.below;
    below = next;
  }
  ends_.resize(buckets, 0);
  chunks_ = std::make_unique_for_overwrite<Chunk[]>(most / kChunk + buckets);
}

std::size_t LabelBuckets::new_chunk(std::size_t previous_end) {
  chunks_[chunk_count_].previous_end = previous_end;
  return kChunk * chunk_count_++;
}

void LabelBuckets::gather(std::size_t end, std::vector<std::uint64_t>& keys,
                          std::vector<std::uint32_t>& rows) const {
  keys.clear();
  rows.clear();
  while (end > 0) {
    const Chunk& chunk = chunks_[(end - 1) / kChunk];
    const auto size = static_cast<std::ptrdiff_t>((end - 1) % kChunk + 1);
    keys.insert(keys.end(), chunk.keys.begin(), chunk.keys.begin() + size);
    rows.insert(rows.end(), chunk.rows.begin(), chunk.rows.begin() + size);
    end = chunk.previous_end;
  }
}

}  // namespace orthoball
