// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "orthoball/filtration/label_buckets.h"
#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// What some lists have in a bucket that got much more than its share, as that of a value that many
/// simplices have: cut into parts of ascending keys by all threads. A key that many numbers have is
/// a part of its own.
class CrowdedBucket {
 public:
  /// Numbers that follow each other.
  struct Part {
    std::size_t begin, end;                ///< of its numbers
    std::optional<std::uint64_t> one_key;  ///< what all have, if that is known
  };

  CrowdedBucket(std::span<const LabelList> lists, std::size_t bucket, Threads threads);

  /// In ascending order of their keys; none is empty. Only those of one key may be large.
  [[nodiscard]] std::span<const Part> parts() const { return parts_; }
  /// The keys of a part in the order in which they came, which has no value where there is one_key.
  [[nodiscard]] std::span<std::uint64_t> keys(const Part& part) {
    return std::span(keys_).subspan(part.begin, part.end - part.begin);
  }
  /// What was added with each.
  [[nodiscard]] std::span<std::uint32_t> rows(const Part& part) {
    return std::span(rows_).subspan(part.begin, part.end - part.begin);
  }

 private:
  struct Piece {
    const LabelPool::Chunk* chunk;
    std::size_t size;
  };

  void choose_splitters(std::span<const Piece> pieces);
  void deal(std::span<const Piece> pieces, Threads threads);

  std::vector<std::uint64_t> splitters_;  // ascending
  std::vector<Part> parts_;
  RawVector<std::uint64_t> keys_;
  RawVector<std::uint32_t> rows_;
};

}  // namespace orthoball
