// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generators/random.h"
#include "orthoball/error.h"
#include "orthoball/input/formats.h"

namespace orthoball {
namespace {

using Strings = std::vector<std::string>;

Reading xyz(const std::string& text, const ReadOptions& options = {}) {
  return read_xyz({"a.xyz", text}, options);
}

std::size_t faulty_line(const std::string& text) {
  try {
    (void)xyz(text);
  } catch (const ParseError& error) {
    return error.line();
  }
  return 0;
}

TEST(Xyz, IsElementsAndPositions) {
  const Reading reading =
      xyz("3\nwater\nO 0.0 0.0 0.0\nH\t0.757 0.586 0.0 \n 1 -0.757 0.586 0\n\n");
  EXPECT_EQ(reading.points.size(), 3U);
  EXPECT_EQ(reading.points.decimals(), 3);
  EXPECT_EQ(reading.points.coordinates()[3], 757);
  EXPECT_EQ(reading.labels.element, (Strings{"O", "H", "H"}));
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{3, 4, 5}));
  EXPECT_TRUE(reading.labels.chain.empty());
}

TEST(Xyz, FindsElementsInLabels) {
  const Reading reading = xyz("4\n\nC12 0 0 0 9 9\nFe3+ 1 0 0\nca 2 0 0\n8 3 0 0\n");
  EXPECT_EQ(reading.labels.element, (Strings{"C", "Fe", "Ca", "O"}));
  EXPECT_EQ(faulty_line("1\n\nLP 0 0 0\n"), 3U);
  EXPECT_EQ(faulty_line("1\n\n119 0 0 0\n"), 3U);
}

TEST(Xyz, RefusesCountsThatLie) {
  EXPECT_EQ(faulty_line("5\n\nO 0 0 0\nH 1 0 0\n"), 1U);
  EXPECT_EQ(faulty_line("1\n\nO 0 0 0\nH 1 0 0\n"), 4U);
  EXPECT_EQ(faulty_line("-3\n\nO 0 0 0\n"), 1U);
  EXPECT_EQ(faulty_line("9223372036854775807\n\nO 0 0 0\n"), 1U);
  EXPECT_EQ(faulty_line("99999999999999999999999999\n\nO 0 0 0\n"), 1U);
  EXPECT_EQ(faulty_line("1\n\nO 0 0 0\n\n2\n\nO 0 0 0\n"), 5U) << "in a later frame";
}

TEST(Xyz, RefusesWhatIsNoNumber) {
  EXPECT_EQ(faulty_line("1\n\nC 1,5 2 3\n"), 3U);
  EXPECT_EQ(faulty_line("1\n\nC 0x1.8p+1 2 3\n"), 3U);
  EXPECT_EQ(faulty_line("1\n\nC 1 2\n"), 3U);
  EXPECT_EQ(xyz("1\n\nC 1.0D+01 2.5d0 -3.0D-1\n").points.coordinate(0, 0), 10.0);
}

TEST(Xyz, TakesTheFirstFrameUnlessAnotherIsNamed) {
  const std::string text = "1\n\nO 0 0 0\n2\n\nC 0 0 0\nC 1 0 0\n";
  const Reading first = xyz(text);
  EXPECT_EQ(first.labels.element, Strings{"O"});
  EXPECT_EQ(first.notes, Strings{"frame 1 of 2 (--model N takes another)"});
  ReadOptions options;
  options.molecule.model = 2;
  EXPECT_EQ(xyz(text, options).points.size(), 2U);
  options.molecule.model = 3;
  EXPECT_THROW((void)xyz(text, options), ParseError);
}

TEST(Xyz, FollowsPropertiesForItsColumns) {
  const Reading reading = xyz(
      "1\nLattice=\"10 0 0 0 10 0 0 0 10\" Properties=id:I:1:pos:R:3:species:S:1 pbc=\"T T F\"\n"
      "7 1 2 3 Si\n");
  EXPECT_EQ(reading.points.coordinate(0, 0), 1.0);
  EXPECT_EQ(reading.labels.element, Strings{"Si"});
  EXPECT_EQ(xyz("1\nProperties=Z:I:1:pos:R:3\n14 1 2 3\n").labels.element, Strings{"Si"});
}

TEST(Xyz, TakesTheRadiiOfTheFileUnlessOthersAreNamed) {
  const std::string text =
      "2\nProperties=species:S:1:pos:R:3:radius:R:1\nC 0 0 0 0.5\nO 1 0 0 1.25\n";
  const Reading reading = xyz(text);
  EXPECT_EQ(reading.radii, "the file's own");
  EXPECT_EQ(reading.points.weight(0), 0.25);
  EXPECT_EQ(reading.points.weight(1), 1.5625);
  EXPECT_EQ(xyz("1\nProperties=radius:R:1:pos:R:3\n2 0 0 0\n").points.weight(0), 4.0);
  ReadOptions options;
  options.radii = "bondi";
  EXPECT_EQ(xyz(text, options).points.weight(0), 2.89);
  options.radii = "none";
  EXPECT_EQ(xyz(text, options).points.weight_kind(), WeightKind::none);
  EXPECT_EQ(faulty_line("1\nProperties=species:S:1:pos:R:3:radius:R:2\nC 0 0 0 1 1\n"), 2U);
  EXPECT_EQ(faulty_line("1\nProperties=species:S:1:pos:R:3:radius:R:1\nC 0 0 0 x\n"), 3U);
}

TEST(Xyz, LooksAtTheRadiiOfTheFileOnlyWhereTheyAreTaken) {
  for (const char* const radii : {"bondi", "alvarez", "protor", "none"}) {
    ReadOptions options;
    options.radii = radii;
    for (const auto model : {std::optional<int>(), std::optional(1)}) {
      options.molecule.model = model;
      const Reading reading =
          xyz("1\nProperties=species:S:1:pos:R:3:radius:R:1\nC 0 0 0 x\n", options);
      EXPECT_EQ(reading.points.size(), 1U) << radii;
    }
  }
}

TEST(Xyz, RefusesPropertiesThatDoNotFit) {
  EXPECT_EQ(faulty_line("1\nProperties=species:S:1:pos:R:3\nC 0 0 0 1\n"), 3U);
  EXPECT_EQ(faulty_line("1\nProperties=species:S:1:pos:R:2\nC 0 0\n"), 2U);
  EXPECT_EQ(faulty_line("1\nProperties=species:S:1\nC\n"), 2U);
  EXPECT_EQ(faulty_line("1\nProperties=species:S\nC\n"), 2U);
  EXPECT_EQ(faulty_line("1\nProperties=pos:R:3:x:R:99999999999999\n0 0 0\n"), 2U);
  EXPECT_EQ(faulty_line("1\nLattice=\"1 0 0 Properties=species:S:1:pos:R:3\nC 0 0 0\n"), 2U);
  EXPECT_EQ(faulty_line("1\nit's \"quoted\n C 0 0 0\n"), 0U) << "a plain comment";
}

TEST(Xyz, WarnsOfALatticeThatIsNone) {
  const Reading reading = xyz("1\nLattice=\"1 0 0\" Properties=species:S:1:pos:R:3\nC 0 0 0\n");
  EXPECT_EQ(reading.warnings.size(), 1U);
}

// All that a reading says; the error if there is none.
std::string description_of(const std::string& text, const ReadOptions& options) {
  try {
    const Reading reading = xyz(text, options);
    std::string words = std::to_string(reading.points.decimals().value_or(-1));
    for (const double x : reading.points.coordinates()) words += ' ' + std::to_string(x);
    for (const double x : reading.points.weights()) words += ' ' + std::to_string(x);
    for (const std::uint32_t line : reading.labels.line) words += ' ' + std::to_string(line);
    for (const auto* const texts : {&reading.labels.element, &reading.labels.atom,
                                    &reading.labels.chain, &reading.notes, &reading.warnings}) {
      // The advice to name a model goes without saying where one is named.
      for (const std::string& each : *texts) words += '|' + each.substr(0, each.find(" (--model"));
    }
    return words + reading.radii + (reading.is_molecule ? " molecule" : "");
  } catch (const ParseError& error) {
    return error.what();
  }
}

TEST(Xyz, PlainFramesAreReadAsAnyOthers) {
  generators::Random random(11);
  const auto pick = [&](const Strings& words) {
    return words[static_cast<std::size_t>(random.integer(0, static_cast<int>(words.size()) - 1))];
  };
  const Strings elements{"C", "H", "ca", "C12", "26", "O", "N"};
  const Strings numbers{"0.5", "-1.25", "3", "0.123456", "1e1", "12.000", "+7"};
  const Strings odd{
      "0.12345678901234567", "1.0000000000000000000", "1e-300", "x", "nan", "1d0", "#"};
  for (int i = 0; i < 5000; ++i) {
    const int atoms = random.integer(1, 5);
    const int more = random.integer(0, 1);
    std::string text = std::to_string(atoms + (random.uniform() < 0.05 ? 1 : 0)) + "\n" +
                       pick({"", "words", "Lattice=\"1 0 0 0 1 0 0 0 1\"", "Lattice=\"1\"",
                             "Properties=species:S:1:pos:R:3", "Properties=Z:I:1:pos:R:3:q:R:1",
                             "Properties=pos:R:3:species:S:1"}) +
                       pick({"\n", "\n", "\r\n", "\r"});
    for (int atom = 0; atom < atoms; ++atom) {
      text += pick({"", "", " ", "\t"}) + (random.uniform() < 0.02 ? "Xx" : pick(elements));
      for (int n = 0; n < 3 + more; ++n) {
        text += pick({" ", "  ", "\t"}) + (random.uniform() < 0.02 ? pick(odd) : pick(numbers));
      }
      text += pick({"\n", "\n", "\n", " \n", "\r\n"});
    }
    text += pick({"", "", "\n", "  \n\n", "1\n\nC 1 2 3\n"});
    ReadOptions options;
    if (random.uniform() < 0.3) options.radii = pick({"none", "bondi", "alvarez", "protor"});
    // Naming the model that is taken anyway makes no difference, but is not plain.
    ReadOptions named = options;
    named.molecule.model = 1;
    ASSERT_EQ(description_of(text, options), description_of(text, named)) << text;
  }
}

}  // namespace
}  // namespace orthoball
