// SPDX-License-Identifier: MIT
#include "orthoball/exact/error_free.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "generators/random.h"
#include "oracles/exact_points.h"

namespace orthoball {
namespace {

using generators::Random;
using oracles::Rational;

double any_double(Random& random, int lowest, int highest) {
  const double digits = random.uniform(1.0, 2.0) * (random.coin() ? 1 : -1);
  return std::ldexp(digits, random.integer(lowest, highest));
}

TEST(TwoSum, LosesNothing) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const int spread = i % 4 == 0 ? 1000 : 60;
    const double a = any_double(random, -spread, spread), b = any_double(random, -spread, spread);
    const Exactly sum = two_sum(a, b);
    EXPECT_EQ(sum.high, a + b);
    EXPECT_EQ(Rational(sum.high) + Rational(sum.low), Rational(a) + Rational(b)) << a << ' ' << b;
  }
}

TEST(TwoSum, LosesNothingBelowTheNormalNumbers) {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  const double normal = std::numeric_limits<double>::min();
  for (const double a : {kLeast, 3 * kLeast, normal, -normal, 1.5 * normal, 1.0}) {
    for (const double b : {kLeast, -kLeast, 5 * kLeast, normal, -1.0}) {
      const Exactly sum = two_sum(a, b);
      EXPECT_EQ(Rational(sum.high) + Rational(sum.low), Rational(a) + Rational(b));
    }
  }
}

TEST(TwoProduct, LosesNothing) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const double a = any_double(random, -200, 200), b = any_double(random, -200, 200);
    const Exactly product = two_product(a, b);
    EXPECT_EQ(product.high, a * b);
    EXPECT_EQ(Rational(product.high) + Rational(product.low), Rational(a) * Rational(b));
  }
}

TEST(TwoProduct, LosesNothingAtTheEdgesOfItsRange) {
  const double odd = 1 + 3 * std::numeric_limits<double>::epsilon();
  for (const auto& [a, b] : {std::pair{odd * 0x1p-484, odd * 0x1p-484},
                             {odd * 0x1p-968, odd},
                             {odd * 0x1p+994, odd * -0x1p+28},
                             {0.0, odd},
                             {odd * 0x1p+994, 0.0},
                             {odd * 0x1p+994, odd * 0x1p-900}}) {
    const Exactly product = two_product(a, b);
    EXPECT_EQ(Rational(product.high) + Rational(product.low), Rational(a) * Rational(b));
  }
}

// A compiler that contracts a * b - c into one operation gives the lost part here instead of 0.
TEST(FloatingPoint, RoundsEveryOperationOnItsOwn) {
  volatile double a = 1 + 0x1p-30, b = 1 - 0x1p-31;
  const double product = a * b;
  volatile double kept = product;
  EXPECT_EQ(a * b - kept, 0.0);
}

}  // namespace
}  // namespace orthoball
