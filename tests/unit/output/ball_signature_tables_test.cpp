// SPDX-License-Identifier: MIT
#include "orthoball/output/ball_signature_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace orthoball {
namespace {

template <class Write>
std::string written(const Write& write, std::string_view missing) {
  std::ostringstream out;
  ByteSink sink(out, missing);
  write(sink);
  return out.str();
}

const std::vector<BallSignatureRow<3>> kRows{{{0, -INFINITY, {0, 0, 0}, 0, 0.0, 0.0}, -INFINITY},
                                             {{3, 2.25, {1, 2, 1}, 0, 0.5, INFINITY}, 1.5}};

TEST(BallSignatureTables, AsCsv) {
  EXPECT_EQ(written([](ByteSink& sink) { write_ball_signatures_csv(sink, kRows); }, ""),
            "index,alpha2,alpha,betti_0,betti_1,betti_2,euler,volume,area\n"
            "0,,,0,0,0,0,0,0\n"
            "3,2.25,1.5,1,2,1,0,0.5,\n");
}

TEST(BallSignatureTables, AsJson) {
  EXPECT_EQ(written([](ByteSink& sink) { write_ball_signatures_json(sink, kRows); }, "null"),
            "[\n"
            "{\"index\":0,\"alpha2\":null,\"alpha\":null,\"betti\":[0,0,0],\"euler\":0,"
            "\"volume\":0,\"area\":0},\n"
            "{\"index\":3,\"alpha2\":2.25,\"alpha\":1.5,\"betti\":[1,2,1],\"euler\":0,"
            "\"volume\":0.5,\"area\":null}\n"
            "]\n");
  const std::vector<BallSignatureRow<2>> none;
  EXPECT_EQ(written([&](ByteSink& sink) { write_ball_signatures_json(sink, none); }, "null"),
            "[\n]\n");
}

TEST(BallSignatureTables, AsAnArchiveHasAllColumns) {
  const std::string bytes =
      written([](ByteSink& sink) { write_ball_signatures_npz(sink, kRows); }, "");
  for (const char* name : {"index.npy", "alpha2.npy", "alpha.npy", "betti.npy", "euler.npy",
                           "volume.npy", "area.npy"}) {
    EXPECT_NE(bytes.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace orthoball
