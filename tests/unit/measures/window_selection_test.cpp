// SPDX-License-Identifier: MIT
#include "orthoball/measures/window_selection.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace orthoball {
namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(SelectInWindow, FindsWhatIsWantedAndInside) {
  std::mt19937 random(7);
  Numbers enters(1000);
  for (std::uint32_t& index : enters) index = static_cast<std::uint32_t>(random());
  std::vector<std::uint64_t> wanted(enters.size() / 64 + 2);
  for (std::uint64_t& word : wanted) word = random() | std::uint64_t{random()} << 32U;
  Numbers selected;
  for (int round = 0; round < 2000; ++round) {
    const auto below = [&](std::uint32_t bound) {
      return static_cast<std::uint32_t>(random() % bound);
    };
    const std::uint32_t begin = below(1000), end = begin + below(1001 - begin);
    const std::uint32_t first = static_cast<std::uint32_t>(random());
    const std::uint32_t length = below(0xFFFFFFFFU - first);
    const bool all = round % 2 == 0;
    Numbers expected;
    for (std::uint32_t i = begin; i < end; ++i) {
      const bool is_wanted = all || (wanted[i / 64] >> i % 64 & 1U) != 0;
      if (is_wanted && enters[i] >= first && enters[i] - first < length) expected.push_back(i);
    }
    const std::size_t size =
        select_in_window(enters, begin, end, first, length,
                         all ? std::span<const std::uint64_t>() : wanted, selected);
    ASSERT_EQ(Numbers(selected.begin(), selected.begin() + static_cast<std::ptrdiff_t>(size)),
              expected);
  }
}

}  // namespace
}  // namespace orthoball
