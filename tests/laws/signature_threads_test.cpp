// SPDX-License-Identifier: MIT
// The number of threads does not show in the signatures of any sites.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/signatures/signature_scan.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::PointFamily;

template <int D>
bool have_the_same_bytes(const Signature<D>& a, const Signature<D>& b) {
  const auto numbers = [](const Signature<D>& of) {
    return std::array{of.alpha2, of.volume, of.area_singular, of.area_regular, of.area, of.length};
  };
  const auto of_a = numbers(a), of_b = numbers(b);
  return std::memcmp(of_a.data(), of_b.data(), sizeof of_a) == 0 && a.index == b.index &&
         a.betti == b.betti && a.euler == b.euler && a.exterior == b.exterior &&
         a.singular == b.singular && a.regular == b.regular && a.interior == b.interior;
}

// By the scan itself, for scan_signatures leaves small inputs to one thread.
template <int D>
std::vector<Signature<D>> all_signatures(const Filtration<D>& filtration, Threads threads) {
  std::vector<Signature<D>> all(filtration.spectrum_size() + std::size_t{1});
  SignatureScan<D> scan(filtration, threads);
  std::size_t end = 0;
  while (scan.next()) {
    for (std::size_t block = 0; block < scan.block_count(); ++block) {
      end += scan.read(block, std::span(all).subspan(end));
    }
  }
  EXPECT_EQ(end, all.size());
  return all;
}

template <int D>
void expect_the_same_on_all(PointFamily family, std::size_t count) {
  SCOPED_TRACE(::testing::Message() << name(family) << ' ' << D << "D " << count);
  const Filtration<D> filtration(
      regular_triangulation<D>(generators::points_of(family, D, count, 3)));
  const auto of_one = all_signatures(filtration, Threads(1));
  for (const unsigned threads : {2U, 3U, 4U, 16U}) {
    const auto of_many = all_signatures(filtration, Threads(threads));
    ASSERT_EQ(of_many.size(), of_one.size());
    for (std::size_t i = 0; i < of_one.size(); ++i) {
      ASSERT_TRUE(have_the_same_bytes(of_many[i], of_one[i])) << i << ' ' << threads;
    }
  }
}

TEST(SignatureThreads, LeaveTheSameBytes) {
  for (const PointFamily family :
       {PointFamily::uniform, PointFamily::uniform_balls, PointFamily::protein_like,
        PointFamily::grid, PointFamily::cospherical, PointFamily::hidden_heavy,
        PointFamily::coplanar, PointFamily::mixed_scales}) {
    const std::size_t count = generators::is_extreme(family) ? 40 : 8000;
    expect_the_same_on_all<2>(family, count);
    expect_the_same_on_all<3>(family, count);
  }
}

TEST(SignatureThreads, ShareALargeScan) {
  const Filtration<3> filtration(
      regular_triangulation<3>(generators::points_of(PointFamily::uniform, 3, 20000, 1)));
  std::vector<Signature<3>> of_one;
  scan_signatures<3>(
      filtration, [&](const Signature<3>& signature) { of_one.push_back(signature); }, Threads(1));
  std::size_t next = 0;
  scan_signatures<3>(
      filtration,
      [&](const Signature<3>& signature) {
        ASSERT_LT(next, of_one.size());
        ASSERT_TRUE(have_the_same_bytes(signature, of_one[next++]));
      },
      Threads(3));
  EXPECT_EQ(next, of_one.size());
  const std::uint32_t middle = filtration.spectrum_size() / 2;
  EXPECT_EQ(betti_numbers(filtration, middle, Threads(3)), of_one[middle - 1].betti);
}

}  // namespace
}  // namespace orthoball
