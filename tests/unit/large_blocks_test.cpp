// SPDX-License-Identifier: MIT
#include "orthoball/large_blocks.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

#include "orthoball/raw_vector.h"

namespace orthoball {
namespace {

constexpr std::size_t kLarge = 8 * large_blocks::kLeast;

// How often the system had to find and clear a page for the program so far.
long first_touches() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

long first_touches_of_another_block() {
  { const BlockVector<char> before(kLarge, 1); }
  const long touches = first_touches();
  const BlockVector<char> after(kLarge, 2);
  EXPECT_EQ(std::count(after.begin(), after.end(), 2), static_cast<std::ptrdiff_t>(kLarge));
  return first_touches() - touches;
}

TEST(LargeBlocks, AreUsedAgainWhileSomebodyWantsIt) {
  if (!large_blocks::are_reused()) GTEST_SKIP() << "not here";
  const long anew = first_touches_of_another_block();
  const LargeBlockReuse reuse;
  { const LargeBlockReuse another; }
  const long again = first_touches_of_another_block();
  EXPECT_LE(again, anew / 10);
}

TEST(LargeBlocks, AreKeptOnlyMeanwhile) {
  if (!large_blocks::are_reused()) GTEST_SKIP() << "not here";
  {
    const LargeBlockReuse reuse;
    { const BlockVector<char> block(kLarge, 1); }
    EXPECT_GE(large_blocks::kept_bytes(), kLarge);
    const BlockVector<char> half(kLarge / 2, 1);
    EXPECT_EQ(large_blocks::kept_bytes(), kLarge / 2);
  }
  EXPECT_EQ(large_blocks::kept_bytes(), 0U);
}

// Blocks of many sizes, which the memory of others is put together for.
void use_blocks(std::uint32_t seed) {
  std::vector<RawVector<std::uint32_t>> blocks(6);
  for (std::uint32_t round = 0; round < 40; ++round) {
    RawVector<std::uint32_t>& block = blocks[round * 5 % blocks.size()];
    if (!block.empty()) {
      const std::uint32_t first = block[0];
      std::size_t kept = 0;
      for (std::size_t i = 0; i < block.size(); ++i) kept += block[i] == first + i ? 1U : 0U;
      EXPECT_EQ(kept, block.size());
    }
    block = RawVector<std::uint32_t>();
    block.resize(large_blocks::kLeast / 4 + 300'000 * ((round + seed) * 7 % 11));
    for (std::size_t i = 0; i < block.size(); ++i) {
      block[i] = static_cast<std::uint32_t>((round << 24U) + (seed << 30U) + i);
    }
  }
}

TEST(LargeBlocks, KeepTheirContent) {
  const LargeBlockReuse reuse;
  use_blocks(0);
}

TEST(LargeBlocks, AreTakenByManyThreads) {
  const LargeBlockReuse reuse;
  std::vector<std::thread> threads;
  for (std::uint32_t i = 0; i < 4; ++i) threads.emplace_back(use_blocks, i);
  for (std::thread& thread : threads) thread.join();
}

TEST(LargeBlocks, AreAlignedForAnything) {
  struct alignas(4096) Page {
    char bytes[4096];
  };
  RawVector<Page> pages(large_blocks::kLeast / sizeof(Page) + 1);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(pages.data()) % alignof(Page), 0U);
}

TEST(LargeBlocks, MayBeFreedAfterReuseHasEndedAndByAnyThread) {
  std::optional<LargeBlockReuse> reuse(std::in_place);
  BlockVector<char> first(kLarge, 1);
  std::thread([&] { first = BlockVector<char>(); }).join();
  BlockVector<char> second(kLarge, 2);
  BlockVector<char> third(2 * kLarge, 3);
  reuse.reset();
  third = BlockVector<char>();
  EXPECT_EQ(std::count(second.begin(), second.end(), 2), static_cast<std::ptrdiff_t>(kLarge));
}

TEST(LargeBlocks, TooLargeOnesAreRefused) {
  BlockAllocator<std::uint64_t> allocator;
  EXPECT_THROW((void)allocator.allocate(SIZE_MAX / 4), std::bad_alloc);
  if (!large_blocks::are_reused()) return;  // sanitizers do not bear it
  EXPECT_THROW((void)allocator.allocate(SIZE_MAX / 64), std::bad_alloc);
}

}  // namespace
}  // namespace orthoball
