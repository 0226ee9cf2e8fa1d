// SPDX-License-Identifier: MIT
#include "orthoball/output/npz.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cstring>
#include <sstream>
#include <string>

namespace orthoball {
namespace {

template <class T>
T number_at(const std::string& bytes, std::size_t offset) {
  T number;
  std::memcpy(&number, bytes.data() + offset, sizeof(T));
  return number;
}

std::string archive() {
  std::ostringstream out;
  ByteSink sink(out);
  NpzWriter npz(sink);
  const std::array<double, 3> reals{1.5, -2.0, 1e300};
  const std::array<std::uint32_t, 6> counts{1, 2, 3, 4, 5, 6};
  npz.add<double>("alpha2", std::array<std::size_t, 1>{3}, reals);
  npz.add<std::uint32_t>("betti", std::array<std::size_t, 2>{3, 2}, counts);
  npz.add<double>("empty", std::array<std::size_t, 1>{0}, {});
  npz.finish();
  return out.str();
}

TEST(NpzWriter, HeadersAndDirectoryAgreeOnNamesSizesAndChecksums) {
  const std::string bytes = archive();
  const std::size_t end = bytes.size() - 22;
  ASSERT_EQ(number_at<std::uint32_t>(bytes, end), 0x06054b50U);
  EXPECT_EQ(number_at<std::uint16_t>(bytes, end + 10), 3U);
  std::size_t entry = number_at<std::uint32_t>(bytes, end + 16);
  EXPECT_EQ(entry + number_at<std::uint32_t>(bytes, end + 12), end);
  for (const std::string name : {"alpha2.npy", "betti.npy", "empty.npy"}) {
    ASSERT_EQ(number_at<std::uint32_t>(bytes, entry), 0x02014b50U);
    EXPECT_EQ(bytes.substr(entry + 46, name.size()), name);
    const std::size_t local = number_at<std::uint32_t>(bytes, entry + 42);
    ASSERT_EQ(number_at<std::uint32_t>(bytes, local), 0x04034b50U);
    const std::size_t size = number_at<std::uint32_t>(bytes, local + 22);
    EXPECT_EQ(size, number_at<std::uint32_t>(bytes, entry + 24));
    const std::string file = bytes.substr(local + 30 + name.size(), size);
    EXPECT_EQ(crc32_z(0, reinterpret_cast<const Bytef*>(file.data()), file.size()),
              number_at<std::uint32_t>(bytes, local + 14));
    EXPECT_EQ(file.substr(0, 6), "\x93NUMPY");
    entry += 46 + name.size();
  }
}

TEST(NpzWriter, ArraysSayTheirTypeAndShapeAndBeginAtAMultipleOf64) {
  const std::string bytes = archive();
  const std::string file = bytes.substr(bytes.find("\x93NUMPY"));
  const std::size_t header = number_at<std::uint16_t>(file, 8);
  EXPECT_EQ((10 + header) % 64, 0U);
  EXPECT_NE(file.find("'descr': '<f8', 'fortran_order': False, 'shape': (3,)"), std::string::npos);
  EXPECT_EQ(number_at<double>(file, 10 + header), 1.5);
  EXPECT_NE(bytes.find("'descr': '<u4', 'fortran_order': False, 'shape': (3,2,)"),
            std::string::npos);
}

}  // namespace
}  // namespace orthoball
