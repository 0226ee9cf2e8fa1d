// SPDX-License-Identifier: MIT
#include "orthoball/output/packed_arrays.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/output/shapes.h"
#include "unit/output/snapshot_reader.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();

std::string packed(const PackedArrays& arrays) {
  return written([&](ByteSink& sink) { arrays.write(sink, "\"version\":1"); });
}

TEST(PackedArrays, NumbersComeBackWhateverTheirDifferencesAre) {
  const PackedArrays::Numbers numbers{7, kMost, 0, 1, kMost - 1, 0x80000000U, 0x7FFFFFFFU};
  for (const std::size_t stride : {0U, 1U, 2U, 3U, 7U, 9U}) {
    PackedArrays arrays;
    arrays.add("numbers", numbers.size(), stride, [&] { return numbers; });
    const auto read = PackedReader(packed(arrays)).numbers("numbers");
    EXPECT_TRUE(std::equal(read.begin(), read.end(), numbers.begin(), numbers.end())) << stride;
  }
}

TEST(PackedArrays, SmallDifferencesOfEitherSignHaveNothingInTheirHighBytes) {
  PackedArrays arrays;
  arrays.add("numbers", 4, 1, [] { return PackedArrays::Numbers{100, 37, 101, 100}; });
  const std::string bytes = packed(arrays);
  EXPECT_EQ(bytes.substr(bytes.size() - 12), std::string(12, '\0'));
}

TEST(PackedArrays, DoublesAreExactAndFloatsRounded) {
  const double infinity = std::numeric_limits<double>::infinity();
  const PackedArrays::Reals reals{0.1, -0.0, 1e300, -infinity, 5e-324};
  PackedArrays arrays;
  arrays.add("doubles", reals.size(), PackedType::f64, [&] { return reals; });
  arrays.add("floats", 2, PackedType::f32, [] { return PackedArrays::Reals{0.1, -2.5}; });
  const PackedReader read(packed(arrays));
  EXPECT_EQ(read.reals("doubles"), std::vector<double>(reals.begin(), reals.end()));
  EXPECT_EQ(read.reals("floats"), (std::vector<double>{0.1F, -2.5}));
}

TEST(PackedArrays, EveryArrayBeginsAtAMultipleOf8) {
  PackedArrays arrays;
  arrays.add("one", 1, 0, [] { return PackedArrays::Numbers{1}; });
  arrays.add("none", 0, 0, [] { return PackedArrays::Numbers{}; });
  arrays.add("last", 3, 0, [] { return PackedArrays::Numbers{4, 5, 6}; });
  const std::string bytes = packed(arrays);
  const PackedReader read(bytes);
  EXPECT_EQ(read.array("one")["offset"], 0);
  EXPECT_EQ(read.array("none")["offset"], 8);
  EXPECT_EQ(read.array("last")["offset"], 8);
  EXPECT_EQ(read.numbers("last"), (std::vector<std::uint32_t>{4, 5, 6}));
  EXPECT_EQ(bytes.size() % 8, 0U);
}

}  // namespace
}  // namespace orthoball
