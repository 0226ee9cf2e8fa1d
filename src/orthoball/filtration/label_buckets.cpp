// SPDX-License-Identifier: MIT
//
// Numbers are dealt to as many buckets as there are cache lines within reach, then each bucket to
// as many parts as it has numbers, by the same rule. Then nearly all are in their places, and
// insertion finishes; parts that got many, as where the sample was unlike, are sorted as they are.
#include "orthoball/filtration/label_buckets.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace orthoball {
namespace {

constexpr std::size_t kLabelsPerBucket = 32768;
constexpr unsigned kPlaceBits = 16;  // within a bucket
constexpr std::size_t kFew = 24;

}  // namespace

BucketRule::BucketRule(std::size_t numbers, std::span<const double> sample)
    : buckets_(std::clamp<std::size_t>(numbers / kLabelsPerBucket, 1, 0xFFFF)), shares_(4096) {
  for (const double label : sample) ++shares_[ordered_key(label) >> 52U].within;
  const std::uint64_t whole = (buckets_ << kPlaceBits) - 1;
  const std::uint64_t size = std::max<std::uint64_t>(sample.size(), 1);
  std::uint64_t below = 0;
  for (Share& share : shares_) {
    const std::uint64_t next = below + share.within;
    share.below = static_cast<std::uint32_t>(below * whole / size);
    share.within = static_cast<std::uint32_t>(next * whole / size) - share.below;
    below = next;
  }
}

LabelPool::LabelPool(std::size_t numbers, std::size_t buckets, std::size_t lists)
    : chunks_(numbers / kChunk + (buckets + kTaken) * lists), nexts_(chunks_.size()) {}

void LabelList::begin_chunk(std::size_t bucket) {
  if (next_chunk_ % LabelPool::kTaken == 0) next_chunk_ = pool_->take();
  const std::uint32_t chunk = next_chunk_++;
  const std::size_t end = ends_[bucket];
  if (end == 0) {
    firsts_[bucket] = chunk;
  } else {
    pool_->next(end / kEnd - 1) = chunk;
    in_full_chunks_[bucket] += static_cast<std::uint32_t>(LabelPool::kChunk);
  }
  ends_[bucket] = kEnd * chunk + kBegin;
}

// Calls `visit(key, row)` for the numbers of the bucket. Chunks are far from each other in memory.
template <class Visit>
void BucketSorter::for_each(const Visit& visit) const {
  constexpr std::size_t kAhead = 1;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (i + kAhead < pieces_.size()) pieces_[i + kAhead].chunk->fetch();
    const auto& [chunk, size] = pieces_[i];
    for (std::size_t j = 0; j < size; ++j) visit(chunk->key(j), chunk->row(j));
  }
}

void BucketSorter::sort(std::span<const LabelList> lists, std::size_t bucket) {
  pieces_.clear();
  std::size_t size = 0;
  for (const LabelList& list : lists) {
    list.for_each_chunk(bucket, [&](const LabelPool::Chunk& chunk, std::size_t numbers) {
      pieces_.push_back({&chunk, numbers});
      size += numbers;
    });
  }
  keys_.resize(size);
  rows_.resize(size);
  const unsigned bits = std::min(kPlaceBits, static_cast<unsigned>(std::bit_width(size / 2)));
  const auto part = [&](std::uint64_t key) {
    return (rule_->place(key) & ((1U << kPlaceBits) - 1)) >> (kPlaceBits - bits);
  };
  ends_.assign(std::size_t{1} << bits, 0);
  for_each([&](std::uint64_t key, std::uint32_t) { ++ends_[part(key)]; });
  std::uint32_t first = 0;
  std::uint32_t most = 0;
  for (std::uint32_t& count : ends_) {
    most = std::max(most, count);
    first += std::exchange(count, first);
  }
  for_each([&](std::uint64_t key, std::uint32_t row) {
    const std::uint32_t place = ends_[part(key)]++;
    keys_[place] = key;
    rows_[place] = row;
  });
  if (most > kFew) sort_crowded_parts();
  insert_in_order(keys_, rows_);
}

void BucketSorter::sort_crowded_parts() {
  std::size_t begin = 0;
  for (const std::uint32_t end : ends_) {
    const std::size_t size = end - begin;
    if (size > kFew) {
      crowded_.sort(std::span(keys_).subspan(begin, size), std::span(rows_).subspan(begin, size));
    }
    begin = end;
  }
}

}  // namespace orthoball
