// SPDX-License-Identifier: MIT
#include "orthoball/exact/wide_integer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

#include "generators/random.h"
#include "oracles/exact_points.h"

namespace orthoball {
namespace {

using generators::Random;
using oracles::Integer;

constexpr auto kLeast = std::numeric_limits<std::int64_t>::min();
constexpr auto kMost = std::numeric_limits<std::int64_t>::max();

// The number in 64 N bits that has these low bits.
template <int N>
Integer wrapped(Integer number) {
  const Integer modulus = Integer(1) << (64 * N);
  number %= modulus;
  if (number < 0) number += modulus;
  if (number >= modulus / 2) number -= modulus;
  return number;
}

template <int N>
Integer integer(const WideInteger<N>& number) {
  Integer sum = 0;
  for (std::size_t i = std::size_t{N}; i-- > 0;) sum = (sum << 64) + number.limbs()[i];
  return wrapped<N>(sum);
}

template <int N>
WideInteger<N> wide(const std::vector<std::uint64_t>& limbs) {
  WideInteger<N> number;
  for (std::size_t i = limbs.size(); i-- > 0;) {
    // Two halves: each fits a signed word.
    number = (number << 32) + WideInteger<N>(static_cast<std::int64_t>(limbs[i] >> 32U));
    number = (number << 32) + WideInteger<N>(static_cast<std::int64_t>(limbs[i] & 0xFFFFFFFFU));
  }
  return number;
}

// Random ones, and the edges: 0, 1, -1, the least and the most, limbs that are empty or full.
template <int N>
std::vector<WideInteger<N>> numbers() {
  Random random(7);
  std::vector<WideInteger<N>> all{0, 1, -1, 2, kLeast, kMost};
  std::vector<std::uint64_t> limbs(std::size_t{N});
  limbs.back() = std::uint64_t{1} << 63U;
  all.push_back(wide<N>(limbs));  // the least
  all.push_back(all.back() - 1);  // the most, by wrapping
  for (int i = 0; i < 40; ++i) {
    for (std::uint64_t& limb : limbs) {
      const int kind = random.integer(0, 5);
      limb = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : random.bits();
    }
    all.push_back(wide<N>(limbs));
    // Short for their width, as most numbers are.
    all.push_back(WideInteger<N>(static_cast<std::int64_t>(random.bits()))
                  << random.integer(0, 64 * N - 1));
  }
  return all;
}

template <class Width>
class EveryWidth : public ::testing::Test {};
template <int N>
struct Width {
  static constexpr int kLimbs = N;
};
// 16 and 17 lie on both sides of the switch in products; 20 = 4 * 5 and 180 come from power tests.
using Widths = ::testing::Types<Width<1>, Width<2>, Width<3>, Width<4>, Width<5>, Width<8>,
                                Width<16>, Width<17>, Width<36>, Width<64>>;
TYPED_TEST_SUITE(EveryWidth, Widths);

TYPED_TEST(EveryWidth, ComputesLikeIntegersModuloItsRange) {
  constexpr int N = TypeParam::kLimbs;
  const auto all = numbers<N>();
  for (const auto& a : all) {
    const Integer x = integer<N>(a);
    EXPECT_EQ(integer<N>(-a), wrapped<N>(-x));
    EXPECT_EQ(a.sign(), Sign(x.sign()));
    for (const auto& b : all) {
      const Integer y = integer<N>(b);
      EXPECT_EQ(integer<N>(a + b), wrapped<N>(x + y));
      EXPECT_EQ(integer<N>(a - b), wrapped<N>(x - y));
      EXPECT_EQ(integer<N>(a * b), wrapped<N>(x * y));
    }
  }
}

TYPED_TEST(EveryWidth, ComparesLikeIntegers) {
  constexpr int N = TypeParam::kLimbs;
  const auto all = numbers<N>();
  for (const auto& a : all) {
    for (const auto& b : all) {
      EXPECT_EQ(a < b, integer<N>(a) < integer<N>(b));
      EXPECT_EQ(a == b, integer<N>(a) == integer<N>(b));
      EXPECT_EQ(a >= b, integer<N>(a) >= integer<N>(b));
    }
  }
}

TYPED_TEST(EveryWidth, ShiftsByAnyNumberOfBits) {
  constexpr int N = TypeParam::kLimbs;
  for (const auto& a : numbers<N>()) {
    for (int bits = 0; bits < 64 * N; bits += bits % 64 == 1 ? 61 : 1) {
      EXPECT_EQ(integer<N>(a << bits), wrapped<N>(integer<N>(a) * (Integer(1) << bits))) << bits;
    }
  }
}

TYPED_TEST(EveryWidth, CountsBitsOfTheMagnitude) {
  constexpr int N = TypeParam::kLimbs;
  for (const auto& a : numbers<N>()) {
    const Integer magnitude = abs(integer<N>(a));
    EXPECT_EQ(a.bit_length(), magnitude == 0 ? 0 : static_cast<int>(msb(magnitude)) + 1);
  }
}

TYPED_TEST(EveryWidth, KeepsItsValueWhereItIsResized) {
  constexpr int N = TypeParam::kLimbs;
  for (const auto& a : numbers<N>()) {
    EXPECT_EQ(integer<N + 3>(a.template resized<N + 3>()), integer<N>(a));
    EXPECT_EQ((a.template resized<N + 3>().template resized<N>()), a);
    const WideInteger<1> low = a.template resized<1>();
    EXPECT_EQ(integer<1>(low), wrapped<1>(integer<N>(a)));
    EXPECT_EQ(a.lowest_limb(), low.limbs()[0]);
  }
}

template <int N, int M>
void check_products() {
  for (const auto& a : numbers<N>()) {
    for (const auto& b : numbers<M>()) {
      EXPECT_EQ((integer<N + M>(product(a, b))), integer<N>(a) * integer<M>(b));
    }
  }
}

TEST(WideIntegerProduct, FitsTheLimbsOfItsFactors) {
  check_products<1, 1>();
  check_products<1, 2>();
  check_products<2, 1>();
  check_products<2, 2>();
  check_products<3, 2>();
  check_products<2, 3>();
  check_products<4, 6>();
  check_products<8, 16>();
  check_products<36, 72>();
}

TEST(WideInteger, IsUsableAtCompileTime) {
  constexpr WideInteger<2> kSquare = WideInteger<2>(kMost) * WideInteger<2>(kMost);
  static_assert(kSquare.bit_length() == 126);
  static_assert(product(WideInteger<1>(-3), WideInteger<1>(5)) == WideInteger<2>(-15));
  static_assert(WideInteger<3>(-1) < WideInteger<3>(0));
}

TEST(WideInteger, AssignsTheResultsOfItsOperators) {
  WideInteger<2> number = 5;
  number += 3;
  number *= -4;
  number -= 1;
  EXPECT_EQ(number, WideInteger<2>(-33));
}

}  // namespace
}  // namespace orthoball
