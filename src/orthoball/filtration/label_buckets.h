// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/key_sort.h"
#include "orthoball/radix_sort.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// Buckets in ascending order for numbers, so chosen by a sample that each gets about as many as
/// fit the nearest caches twice. Where the sample is unlike the numbers that costs time, nothing
/// else.
class BucketRule {
 public:
  /// @param numbers  how many numbers there will be at most
  /// @param sample   some like those to come, in any order
  BucketRule(std::size_t numbers, std::span<const double> sample);

  [[nodiscard]] std::size_t bucket_count() const { return buckets_; }
  /// Where an ordered_key would come in the sorted sample, between numbers of one exponent by
  /// proportion: never falls as keys grow.
  /// @return 2^16 * bucket + the place within it.
  [[nodiscard]] std::uint32_t place(std::uint64_t key) const {
    const Share share = shares_[key >> 52U];
    const std::uint64_t mantissa = key >> 20U & 0xFFFFFFFFU;
    return share.below + static_cast<std::uint32_t>(share.within * mantissa >> 32U);
  }

 private:
  // The places below a sign and exponent, and between these and the next.
  struct Share {
    std::uint32_t below;
    std::uint32_t within;
  };

  std::size_t buckets_;
  std::vector<Share> shares_;  // [sign and exponent of an ordered_key]
};

/// Memory for numbers that several LabelLists deal out, from any number of threads.
///
/// What has not been needed is not touched.
class LabelPool {
 public:
  /// Room for `numbers` dealt to `buckets` buckets of `lists` lists.
  LabelPool(std::size_t numbers, std::size_t buckets, std::size_t lists);

  static constexpr std::size_t kChunk = 340;  ///< numbers
  static constexpr std::uint32_t kTaken = 8;  ///< chunks at a time

  /// Some numbers with a row each: a page.
  class alignas(4096) Chunk {
   public:
    [[nodiscard]] std::uint64_t key(std::size_t i) const {
      return std::uint64_t{words_[3 * i + 1]} << 32U | words_[3 * i];
    }
    [[nodiscard]] std::uint32_t row(std::size_t i) const { return words_[3 * i + 2]; }
    void set(std::size_t i, std::uint64_t key, std::uint32_t row) {
      words_[3 * i] = static_cast<std::uint32_t>(key);
      words_[3 * i + 1] = static_cast<std::uint32_t>(key >> 32U);
      words_[3 * i + 2] = row;
    }
    /// Asks for it before it is read.
    [[gnu::always_inline]] void fetch() const {
      for (std::size_t i = 0; i < words_.size(); i += 16) __builtin_prefetch(&words_[i]);
    }

   private:
    std::array<std::uint32_t, 3 * kChunk> words_;
  };

  [[nodiscard]] Chunk& operator[](std::size_t chunk) { return chunks_[chunk]; }
  [[nodiscard]] const Chunk& operator[](std::size_t chunk) const { return chunks_[chunk]; }
  /// [chunk]: the next of the same bucket and list, if there is one.
  [[nodiscard]] std::uint32_t& next(std::size_t chunk) { return nexts_[chunk]; }
  [[nodiscard]] std::uint32_t next(std::size_t chunk) const { return nexts_[chunk]; }
  /// The first of kTaken chunks that nobody else has.
  [[nodiscard]] std::uint32_t take() { return used_.fetch_add(kTaken, std::memory_order_relaxed); }

 private:
  RawVector<Chunk> chunks_;
  RawVector<std::uint32_t> nexts_;
  std::atomic<std::uint32_t> used_ = 0;
};

/// Numbers with what belongs to each, dealt to buckets as they come. 12 bytes a number.
class LabelList {
 public:
  /// Keeps references to both.
  LabelList(const BucketRule& rule, LabelPool& pool)
      : rule_(&rule),
        pool_(&pool),
        ends_(rule.bucket_count(), 0),
        firsts_(rule.bucket_count(), 0),
        in_full_chunks_(rule.bucket_count(), 0) {}

  /// Not NaN.
  void add(double label, std::uint32_t row) {
    const std::uint64_t key = ordered_key(label);
    const std::size_t bucket = rule_->place(key) >> 16U;
    if (ends_[bucket] % kEnd == 0) begin_chunk(bucket);
    const std::size_t end = ends_[bucket]++;
    (*pool_)[end / kEnd].set(end % kEnd - kBegin, key, row);
  }

  /// How many numbers a bucket has.
  [[nodiscard]] std::size_t size(std::size_t bucket) const {
    const std::size_t end = ends_[bucket];
    return in_full_chunks_[bucket] + (end == 0 ? 0 : (end - 1) % kEnd + 1 - kBegin);
  }
  /// Calls `visit(chunk, size)` for the chunks of a bucket in the order in which they were filled.
  template <class Visit>
  void for_each_chunk(std::size_t bucket, const Visit& visit) const {
    std::uint32_t chunk = firsts_[bucket];
    for (std::size_t left = size(bucket); left > 0; chunk = pool_->next(chunk)) {
      const std::size_t here = left < LabelPool::kChunk ? left : LabelPool::kChunk;
      visit((*pool_)[chunk], here);
      left -= here;
    }
  }

 private:
  // An end is kEnd * chunk + kBegin + the numbers in it: a multiple of kEnd where it is full, and 0
  // before the first.
  static constexpr std::size_t kEnd = 512;
  static constexpr std::size_t kBegin = kEnd - LabelPool::kChunk;

  void begin_chunk(std::size_t bucket);

  const BucketRule* rule_;
  LabelPool* pool_;
  std::vector<std::size_t> ends_;              // [bucket]
  std::vector<std::uint32_t> firsts_;          // [bucket]: its first chunk
  std::vector<std::uint32_t> in_full_chunks_;  // [bucket]: numbers before the last chunk
  std::uint32_t next_chunk_ = 0;               // of those taken from the pool
};

/// Sorts the buckets of some lists, one at a time.
class BucketSorter {
 public:
  explicit BucketSorter(const BucketRule& rule) : rule_(&rule) {}

  /// Sorts what the lists have in a bucket by ascending numbers; equal ones stay in the order of
  /// the lists, and within each in that in which they came.
  void sort(std::span<const LabelList> lists, std::size_t bucket);

  /// [i]: the ordered_key of each number, and what was added with it. Valid until the next call.
  [[nodiscard]] std::span<const std::uint64_t> keys() const { return keys_; }
  [[nodiscard]] std::span<std::uint32_t> rows() { return rows_; }

 private:
  struct Piece {
    const LabelPool::Chunk* chunk;
    std::size_t size;
  };

  template <class Visit>
  void for_each(const Visit& visit) const;
  void sort_crowded_parts();

  const BucketRule* rule_;
  KeySorter crowded_;
  std::vector<Piece> pieces_;  // of the bucket
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> rows_;
  std::vector<std::uint32_t> ends_;  // [part of the bucket]
};

}  // namespace orthoball
