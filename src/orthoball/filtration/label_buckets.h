// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "orthoball/filtration/key_sort.h"
#include "orthoball/radix_sort.h"

namespace orthoball {

/// Numbers with what belongs to each, gathered in any order and given back in ascending order, a
/// part that fits the cache at a time.
///
/// A sample decides which numbers go together: it costs time where it is unlike the others, nothing
/// else. 12 bytes a number; memory that no number has reached is not touched.
class LabelBuckets {
 public:
  /// @param most    how many numbers will be added at most
  /// @param sample  numbers like those to come, in any order
  LabelBuckets(std::size_t most, std::span<const double> sample);

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Not NaN.
  void add(double label, std::uint32_t row) {
    const std::uint64_t key = ordered_key(label);
    std::size_t& place = ends_[bucket(key)];
    if (place % kChunk == 0) place = new_chunk(place);
    Chunk& chunk = chunks_[place / kChunk];
    chunk.keys[place % kChunk] = key;
    chunk.rows[place % kChunk] = row;
    ++place;
    ++size_;
  }

  /// Calls `visit(keys, rows)` for parts whose numbers ascend, within each and from each to the
  /// next: `keys[i]` is the ordered_key of a number and `rows[i]` what was added with it. Equal
  /// numbers are in one part.
  template <class Visit>
  void for_each_part(const Visit& visit) const {
    KeySorter sorter;
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> rows;
    for (const std::size_t end : ends_) {
      gather(end, keys, rows);
      sorter.sort(keys, rows);
      visit(std::span<const std::uint64_t>(keys), std::span<std::uint32_t>(rows));
    }
  }

 private:
  static constexpr std::size_t kChunk = 128;
  struct Chunk {
    std::array<std::uint64_t, kChunk> keys;
    std::array<std::uint32_t, kChunk> rows;
    std::size_t previous_end;  // as in ends_: what the chunk before has, if there is one
  };
  // The share of the sample below a sign and exponent, and between these and the next, in
  // 2^-kFractionBits buckets.
  struct Share {
    std::uint32_t below;
    std::uint32_t within;
  };
  static constexpr unsigned kFractionBits = 16;

  // Where the key would come in the sorted sample, between numbers of one exponent by proportion:
  // it never falls as keys grow.
  [[nodiscard]] std::size_t bucket(std::uint64_t key) const {
    const Share share = shares_[key >> 52U];
    const std::uint64_t mantissa = key >> 20U & 0xFFFFFFFFU;
    return (share.below + static_cast<std::uint32_t>(share.within * mantissa >> 32U)) >>
           kFractionBits;
  }
  std::size_t new_chunk(std::size_t previous_end);
  void gather(std::size_t end, std::vector<std::uint64_t>& keys,
              std::vector<std::uint32_t>& rows) const;

  std::vector<Share> shares_;      // [sign and exponent of an ordered_key]
  std::vector<std::size_t> ends_;  // [bucket]: kChunk * last chunk + numbers in it; 0 without any
  std::unique_ptr<Chunk[]> chunks_;
  std::size_t chunk_count_ = 0;
  std::size_t size_ = 0;
};

}  // namespace orthoball
