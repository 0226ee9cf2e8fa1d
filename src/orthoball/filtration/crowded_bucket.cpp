// SPDX-License-Identifier: MIT
//
// Sample sort with parts for equal keys: keys are dealt to the ranges between some of them, and
// these have ranges of their own. Every thread counts its pieces of the bucket, and then knows
// where its numbers go.
#include "orthoball/filtration/crowded_bucket.h"

#include <algorithm>
#include <array>
#include <utility>

namespace orthoball {
namespace {

constexpr std::size_t kSample = 2048;
constexpr std::size_t kMostSplitters = 31;
constexpr std::size_t kMostRanges = 2 * kMostSplitters + 1;
constexpr std::size_t kPiecesOfPart = 64;

}  // namespace

CrowdedBucket::CrowdedBucket(std::span<const LabelList> lists, std::size_t bucket,
                             Threads threads) {
  std::vector<Piece> pieces;
  std::size_t size = 0;
  for (const LabelList& list : lists) {
    list.for_each_chunk(bucket, [&](const LabelPool::Chunk& chunk, std::size_t numbers) {
      pieces.push_back({&chunk, numbers});
      size += numbers;
    });
  }
  keys_.resize(size);
  rows_.resize(size);
  choose_splitters(pieces);
  deal(pieces, threads);
}

void CrowdedBucket::choose_splitters(std::span<const Piece> pieces) {
  std::vector<std::uint64_t> sample;
  for (std::size_t i = 0; i < pieces.size(); i += pieces.size() / kSample + 1) {
    sample.push_back(pieces[i].chunk->key(i % pieces[i].size));
  }
  std::sort(sample.begin(), sample.end());
  for (std::size_t i = 1; i <= kMostSplitters && !sample.empty(); ++i) {
    splitters_.push_back(sample[i * (sample.size() - 1) / (kMostSplitters + 1)]);
  }
  splitters_.erase(std::unique(splitters_.begin(), splitters_.end()), splitters_.end());
}

// Range 2 i is below splitter i, range 2 i + 1 has what is equal to it.
void CrowdedBucket::deal(std::span<const Piece> pieces, Threads threads) {
  const auto range = [&](std::uint64_t key) {
    std::size_t i = 0;
    while (i < splitters_.size() && splitters_[i] < key) ++i;
    return 2 * i + (i < splitters_.size() && splitters_[i] == key ? 1 : 0);
  };
  const std::size_t parts = pieces.size() / kPiecesOfPart + 1;
  // [part of the pieces][range]: how many numbers, then where the next goes.
  std::vector<std::array<std::size_t, kMostRanges>> next(parts);
  const auto for_each_part = [&](const auto& visit) {
    parallel_parts(threads, pieces.size(), parts,
                   [&](std::size_t part, std::size_t begin, std::size_t end) {
                     for (const auto& [chunk, size] : pieces.subspan(begin, end - begin)) {
                       for (std::size_t i = 0; i < size; ++i) visit(next[part], *chunk, i);
                     }
                   });
  };
  for_each_part([&](auto& counts, const LabelPool::Chunk& chunk, std::size_t i) {
    ++counts[range(chunk.key(i))];
  });
  std::size_t begin = 0;
  for (std::size_t r = 0; r <= 2 * splitters_.size(); ++r) {
    std::size_t end = begin;
    for (auto& counts : next) end += std::exchange(counts[r], end);
    if (end > begin) {
      parts_.push_back({begin, end, std::nullopt});
      if (r % 2 == 1) parts_.back().one_key = splitters_[r / 2];
    }
    begin = end;
  }
  for_each_part([&](auto& places, const LabelPool::Chunk& chunk, std::size_t i) {
    const std::uint64_t key = chunk.key(i);
    const std::size_t r = range(key);
    const std::size_t place = places[r]++;
    rows_[place] = chunk.row(i);
    if (r % 2 == 0) keys_[place] = key;
  });
}

}  // namespace orthoball
