// SPDX-License-Identifier: MIT
#include "orthoball/filtration/bit_run.h"

#include <gtest/gtest.h>

#include <vector>

#include "orthoball/parallel.h"

namespace orthoball {
namespace {

bool expected(std::size_t place) { return place % 3 == 0 || place % 7 == 2; }

TEST(BitRun, WritesStretchesThatShareWordsAtTheSameTime) {
  constexpr std::size_t kBits = 10000;
  for (const std::size_t parts : {1U, 7U, 700U}) {
    std::vector<std::uint64_t> words(kBits / 64 + 1, 0);
    parallel_parts(Threads(4), kBits, parts, [&](std::size_t, std::size_t begin, std::size_t end) {
      BitRun run(words.data(), begin);
      for (std::size_t place = begin; place < end; ++place) {
        run.push_if(false, true);
        run.push(expected(place));
      }
    });
    for (std::size_t place = 0; place < kBits; ++place) {
      ASSERT_EQ(bit_at(words.data(), place), expected(place)) << "at " << place;
    }
    for (std::size_t place = kBits; place < 64 * words.size(); ++place) {
      ASSERT_FALSE(bit_at(words.data(), place)) << "at " << place;
    }
  }
}

}  // namespace
}  // namespace orthoball
