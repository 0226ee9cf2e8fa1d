// SPDX-License-Identifier: MIT
#include "orthoball/measures/term_bins.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <vector>

namespace orthoball {
namespace {

using Term = std::tuple<std::size_t, unsigned, std::array<double, 2>>;

std::vector<Term> terms_of(const TermBins<2>& bins, std::uint32_t stretch) {
  std::vector<Term> terms;
  bins.for_each(stretch, [&](std::size_t place, unsigned tag, const std::byte* values) {
    std::array<double, 2> numbers;
    std::memcpy(&numbers, values, sizeof numbers);
    terms.emplace_back(place, tag, numbers);
  });
  return terms;
}

TEST(TermBins, GiveBackTheTermsOfAStretchPartAfterPart) {
  TermBins<2> bins;
  const std::vector<std::uint32_t> first_part{2, 0}, second_part{1, 1};
  bins.prepare(5, {first_part, second_part});
  const auto deal = [&](std::size_t part, std::uint32_t index, unsigned tag, double value) {
    const std::array values{value, -value};
    TermBins<2>::Dealer(bins, part).deal(index, tag, values.data());
  };
  deal(1, 6 * kIndexStretch, 15, 4.0);
  deal(1, 6 * kIndexStretch - 1, 3, 3.0);
  deal(0, 5 * kIndexStretch + 7, 0, 1.0);
  deal(0, 5 * kIndexStretch, 1, 2.0);
  EXPECT_EQ(terms_of(bins, 5),
            (std::vector<Term>{
                {7, 0, {1.0, -1.0}}, {0, 1, {2.0, -2.0}}, {kIndexStretch - 1, 3, {3.0, -3.0}}}));
  EXPECT_EQ(terms_of(bins, 6), (std::vector<Term>{{0, 15, {4.0, -4.0}}}));
}

TEST(TermBins, MayHaveFewerTermsThanPrepared) {
  TermBins<2> bins;
  const std::vector<std::uint32_t> many{100};
  bins.prepare(0, {many});
  EXPECT_TRUE(terms_of(bins, 0).empty());
}

}  // namespace
}  // namespace orthoball
