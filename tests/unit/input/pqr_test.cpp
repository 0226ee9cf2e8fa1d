// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/input/formats.h"

namespace orthoball {
namespace {

Reading pqr(const std::string& text, const ReadOptions& options = {}) {
  return read_pqr({"a.pqr", text}, options);
}

TEST(Pqr, HasRadiiOfItsOwn) {
  const Reading reading =
      pqr("REMARK x\nATOM 1 N ALA 1 11.104 6.134 -6.504 -0.300 1.8500\n"
          "ATOM 2 HN ALA 1 11 6 -6 0.3 0.2245\n");
  EXPECT_EQ(reading.radii, "the file's own");
  EXPECT_EQ(reading.points.decimals(), 4);
  EXPECT_EQ(reading.points.weights()[0], 18500);
  EXPECT_EQ(reading.points.weights()[1], 2245);
  EXPECT_EQ(reading.labels.element, (std::vector<std::string>{"N", "H"}));
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{2, 3}));
}

TEST(Pqr, TakesAnotherSetWhenTold) {
  ReadOptions options;
  options.radii = "bondi";
  EXPECT_EQ(pqr("ATOM 1 N ALA 1 0 0 0 0 9\n", options).points.weights()[0], 155);
}

TEST(Pqr, MayNameChains) {
  EXPECT_EQ(pqr("ATOM 1 N ALA A 1 0.0 0 0 0 1\n").labels.chain[0], "A");
  EXPECT_EQ(pqr("ATOM 1 N ALA A1000 0.0 0 0 0 1\n").labels.chain[0], "A");
  EXPECT_EQ(pqr("ATOM 1 N ALA A1000 0.0 0 0 0 1\n").labels.residue_id[0], "1000");
  EXPECT_EQ(pqr("ATOM 1 N ALA -3B 0.0 0 0 0 1\n").labels.residue_id[0], "-3B");
}

TEST(Pqr, NeverTakesTheChargeForTheRadius) {
  EXPECT_THROW((void)pqr("ATOM 1 N ALA 1 11.1 6.1 -6.5 -0.3\n"), ParseError);
  EXPECT_THROW((void)pqr("ATOM 1 N ALA A 1 11.1 6.1 -6.5 -0.3\n"), ParseError);
  EXPECT_THROW((void)pqr("ATOM 1 N ALA B2 1 11.1 6.1 -6.5 -0.3\n"), ParseError);
  EXPECT_THROW((void)pqr("ATOM 1 N ALA 1 11.1 6.1 -6.5 -0.3 1 2 3\n"), ParseError);
  EXPECT_THROW((void)pqr("ATOM 1 N ALA 1 11.1 6.1 -6.5 -0.3 r\n"), ParseError);
}

TEST(Pqr, TakesNegativeRadiiAsImaginaryWithAWarning) {
  const Reading reading = pqr("ATOM 1 N ALA 1 0 0 0 0 -1.5\n");
  EXPECT_EQ(reading.points.weight(0), -2.25);
  EXPECT_EQ(reading.warnings.size(), 1U);
  EXPECT_EQ(pqr("ATOM 1 N ALA 1 0 0 0 0 0.000\n").points.weight(0), 0.0);
}

TEST(Pqr, DropsWaters) {
  EXPECT_EQ(pqr("ATOM 1 N ALA 1 0 0 0 0 1\nHETATM 2 O HOH 2 1 1 1 0 1\n").points.size(), 1U);
}

}  // namespace
}  // namespace orthoball
