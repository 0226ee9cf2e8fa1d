// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/input/formats.h"
#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

using Strings = std::vector<std::string>;

const std::string kNitrogen =
    "ATOM      1  N   ALA A   1      11.104   6.134  -6.504  1.00 10.00           N\n";
const std::string kCarbon =
    "ATOM      2  CA  ALA A   1      11.639   6.071  -5.147  1.00 10.00           C\n";
const std::string kWater =
    "HETATM    3  O   HOH A   2      15.000  15.000  15.000  1.00 10.00           O\n";

Reading pdb(const std::string& text, const ReadOptions& options = {}) {
  return read_pdb({"a.pdb", text}, options);
}

ReadOptions molecule_options(const MoleculeOptions& molecule) {
  ReadOptions options;
  options.molecule = molecule;
  return options;
}

// The line that a text is refused for, 0 if it is not.
std::size_t faulty_line(const std::string& text) {
  try {
    (void)pdb(text);
  } catch (const ParseError& error) {
    EXPECT_EQ(error.file(), "a.pdb");
    return error.line();
  }
  return 0;
}

// kCarbon with `text` from column `column` on.
std::string carbon_with(std::size_t column, const std::string& text) {
  std::string line = kCarbon;
  return line.replace(column - 1, text.size(), text);
}

TEST(Pdb, IsReadAsExactDecimals) {
  const Reading reading = pdb(kNitrogen + kCarbon);
  ASSERT_EQ(reading.points.size(), 2U);
  EXPECT_EQ(reading.points.decimals(), 3);
  EXPECT_EQ(reading.points.weight_kind(), WeightKind::radius);
  EXPECT_EQ(reading.points.coordinates()[0], 11104);
  EXPECT_EQ(reading.points.coordinates()[5], -5147);
  EXPECT_EQ(reading.points.weights()[0], 1550);
  EXPECT_EQ(reading.points.weights()[1], 1700);
  EXPECT_TRUE(reading.is_molecule);
  EXPECT_EQ(reading.radii, "bondi (Bondi 1964, H 1.20)");
  EXPECT_TRUE(reading.notes.empty());
}

TEST(Pdb, KeepsWhoEachAtomIs) {
  const Reading reading = pdb("REMARK\n" + kNitrogen + carbon_with(27, "B"));
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(reading.labels.element, (Strings{"N", "C"}));
  EXPECT_EQ(reading.labels.atom, (Strings{"N", "CA"}));
  EXPECT_EQ(reading.labels.residue, (Strings{"ALA", "ALA"}));
  EXPECT_EQ(reading.labels.residue_id, (Strings{"1", "1B"}));
  EXPECT_EQ(reading.labels.chain, (Strings{"A", "A"}));
}

TEST(Pdb, EndsLinesInAnyWay) {
  std::string crlf = kNitrogen + kCarbon;
  for (std::size_t at = 0; (at = crlf.find('\n', at)) != std::string::npos; at += 2) {
    crlf.replace(at, 1, "\r\n");
  }
  EXPECT_EQ(pdb(crlf).points.size(), 2U);
  std::string cr = kNitrogen + kCarbon;
  for (char& c : cr) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(pdb(cr).points.size(), 2U);
}

TEST(Pdb, RefusesCoordinatesThatAreNoNumbers) {
  for (const char* x : {"********", "  12.3x4", "     nan", "     inf", "        ", "  12 304"}) {
    EXPECT_EQ(faulty_line(kNitrogen + carbon_with(31, x)), 2U) << x;
  }
  EXPECT_EQ(faulty_line(kNitrogen + carbon_with(39, "  6.0 71")), 2U);
}

TEST(Pdb, RefusesLinesThatEndInsideTheCoordinates) {
  for (const std::size_t length : {30U, 38U, 46U, 50U, 53U}) {
    EXPECT_EQ(faulty_line(kNitrogen + kCarbon.substr(0, length)), 2U) << length;
  }
  EXPECT_EQ(faulty_line(kNitrogen + kCarbon.substr(0, 54)), 0U);
}

TEST(Pdb, RefusesShiftedColumns) {
  std::string right = kCarbon;
  right.insert(20, " ");
  EXPECT_EQ(faulty_line(kNitrogen + right), 2U);
  EXPECT_EQ(faulty_line(kNitrogen + carbon_with(30, "111.639")), 2U) << "column 30";
}

TEST(Pdb, DoesNotNeedWhatItDoesNotUse) {
  EXPECT_EQ(faulty_line(carbon_with(7, "A0000")), 0U);
  EXPECT_EQ(faulty_line(carbon_with(7, "*****")), 0U);
  EXPECT_EQ(faulty_line(carbon_with(23, "A000")), 0U);
  EXPECT_EQ(faulty_line(carbon_with(55, "   inf   nan")), 0U);
  EXPECT_EQ(faulty_line(carbon_with(1, "ATOM 123456")), 0U);
  EXPECT_EQ(pdb(carbon_with(1, "ATOM 123456")).points.size(), 1U);
}

TEST(Pdb, TakesNoLineNumberForAnElement) {
  EXPECT_EQ(pdb(carbon_with(73, "1TST  70")).labels.element, Strings{"C"});
  EXPECT_EQ(pdb(carbon_with(73, "1CHB1032")).labels.element, Strings{"C"});
  EXPECT_EQ(pdb(kCarbon.substr(0, 66)).labels.element, Strings{"C"});
  EXPECT_EQ(pdb(carbon_with(77, "CA")).labels.element, Strings{"Ca"});
  EXPECT_EQ(pdb(carbon_with(73, "SEGA C")).labels.element, Strings{"C"});
}

TEST(Pdb, DropsWatersUnlessToldNotTo) {
  const Reading dropped = pdb(kNitrogen + kWater);
  EXPECT_EQ(dropped.points.size(), 1U);
  EXPECT_EQ(dropped.notes, Strings{"waters dropped: 1 atom (--waters keep keeps them)"});
  const Reading kept = pdb(kNitrogen + kWater, molecule_options({.waters = true}));
  EXPECT_EQ(kept.points.size(), 2U);
  EXPECT_TRUE(kept.notes.empty());
}

TEST(Pdb, DropsHydrogensAndLigandsWhenTold) {
  const std::string ligand =
      "HETATM    4  C1  LIG A   3      16.000  15.000  15.000  1.00 10.00           C\n";
  const std::string hydrogen =
      "ATOM      5  H   ALA A   1      10.000   6.000  -6.000  1.00 10.00           H\n";
  const std::string text = kNitrogen + kWater + ligand + hydrogen;
  EXPECT_EQ(pdb(text).points.size(), 3U);
  EXPECT_EQ(pdb(text, molecule_options({.hydrogens = false})).points.size(), 2U);
  EXPECT_EQ(pdb(text, molecule_options({.ligands = false})).points.size(), 2U);
  EXPECT_EQ(pdb(text, molecule_options({.ligands = false, .waters = true})).points.size(), 3U);
}

TEST(Pdb, TakesTheFirstModelUnlessAnotherIsNamed) {
  const std::string text = "MODEL        3\n" + kNitrogen + "ENDMDL\nMODEL        4\n" + kCarbon +
                           "ENDMDL\nMODEL        4\n" + kCarbon + kCarbon + "ENDMDL\nEND\n";
  const Reading first = pdb(text);
  EXPECT_EQ(first.labels.atom, Strings{"N"});
  EXPECT_EQ(first.notes, Strings{"model 3 of the models 3 to 5 (--model N takes another)"});
  EXPECT_EQ(pdb(text, molecule_options({.model = 4})).points.size(), 1U);
  EXPECT_EQ(pdb(text, molecule_options({.model = 5})).points.size(), 2U) << "the number again";
  EXPECT_THROW((void)pdb(text, molecule_options({.model = 1})), ParseError);
}

TEST(Pdb, NamesModelsByTheirNumbers) {
  const auto file = [](std::initializer_list<int> numbers) {
    std::string text;
    for (const int number : numbers) {
      text += "MODEL " + std::string(number < 10 ? "       " : "      ") + std::to_string(number) +
              "\n" + kNitrogen + "ENDMDL\n";
    }
    return text;
  };
  const auto note = [&](std::initializer_list<int> numbers, int wanted) {
    return pdb(file(numbers), molecule_options({.model = wanted})).notes.at(0);
  };
  EXPECT_EQ(note({1, 2, 3}, 2), "model 2 of 3");
  EXPECT_EQ(note({2, 5}, 5), "model 5 of the models 2, 5");
  EXPECT_EQ(note({0, 1, 2}, 0), "model 0 of the models 0 to 2");
  EXPECT_EQ(note({2, 4, 6, 8, 10, 12, 14, 16, 18, 20}, 2),
            "model 2 of the models 2, 4, 6, 8, 10, 12, 14, 16, ... 20");
  EXPECT_EQ(error_of(read_pdb, file({2, 5}), molecule_options({.model = 1})),
            "f: no model 1; the file has models 2, 5");
  EXPECT_EQ(error_of(read_pdb, file({2}), molecule_options({.model = 1})),
            "f: no model 1; the file has model 2");
}

TEST(Pdb, SeparatesModelsWithoutNumbersByEnd) {
  EXPECT_EQ(pdb(kNitrogen + "ENDMDL\n" + kCarbon + "ENDMDL\n").points.size(), 1U);
  EXPECT_EQ(pdb(kNitrogen + "END\n" + kCarbon + "END\n").points.size(), 1U);
  EXPECT_EQ(pdb(kNitrogen + "TER\n" + kCarbon + "END\n").points.size(), 2U);
}

TEST(Pdb, TakesTheAlternateOfTheHighestOccupancy) {
  const std::string a = "ATOM      5  CB AALA A   1      10.504   6.229  -4.141  0.40\n";
  const std::string b = "ATOM      6  CB BALA A   1      10.600   6.400  -4.000  0.60\n";
  const Reading reading = pdb(kNitrogen + a + b);
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(reading.notes,
            Strings{"alternates: the highest occupancy, the first on ties; 1 atom left out "
                    "(--altloc X prefers X)"});
  EXPECT_EQ(pdb(kNitrogen + a + b, molecule_options({.altloc = "A"})).labels.line,
            (std::vector<std::uint32_t>{1, 2}));
}

TEST(Pdb, TakesTheFirstAlternateOnTies) {
  const std::string a = "ATOM      5  CB AALA A   1      10.504   6.229  -4.141  0.50\n";
  const std::string b = "ATOM      6  CB BALA A   1      10.600   6.400  -4.000  0.50\n";
  EXPECT_EQ(pdb(a + b).labels.line, std::vector<std::uint32_t>{1});
  EXPECT_EQ(pdb(b + a).labels.line, std::vector<std::uint32_t>{1});
}

TEST(Pdb, KeepsALoneAlternateAndDuplicates) {
  const std::string b = "ATOM      6  CB BALA A   1      10.600   6.400  -4.000  0.10\n";
  EXPECT_EQ(pdb(kNitrogen + b).points.size(), 2U);
  EXPECT_EQ(pdb(kNitrogen + b, molecule_options({.altloc = "A"})).points.size(), 2U);
  EXPECT_EQ(pdb(kCarbon + kCarbon).points.size(), 2U) << "duplicates are no alternates";
}

TEST(Pdb, TakesOneOfTwoResiduesInOnePlace) {
  const std::string text =
      "ATOM      1  N  ASER A  22       1.000   1.000   1.000  0.40\n"
      "ATOM      2  OG ASER A  22       2.000   1.000   1.000  0.40\n"
      "ATOM      3  N  BPRO A  22       1.000   1.000   1.000  0.60\n"
      "ATOM      4  CG BPRO A  22       3.000   1.000   1.000  0.60\n";
  EXPECT_EQ(pdb(text).labels.residue, (Strings{"PRO", "PRO"}));
  EXPECT_EQ(pdb(text, molecule_options({.altloc = "A"})).labels.residue, (Strings{"SER", "SER"}));
}

TEST(Pdb, TakesTheChainsThatAreNamed) {
  const std::string text = kNitrogen + carbon_with(22, "B");
  EXPECT_EQ(pdb(text, molecule_options({.chains = {"B"}})).labels.chain, Strings{"B"});
  EXPECT_EQ(pdb(text, molecule_options({.chains = {"B", "A"}})).points.size(), 2U);
  EXPECT_THROW((void)pdb(text, molecule_options({.chains = {"C"}})), ParseError);
}

TEST(Pdb, NamesTheAtomWithoutARadius) {
  const std::string unknown =
      "HETATM    6  X1  UNK A   2      15.000  15.000  15.000  1.00 10.00          Xx\n";
  try {
    (void)pdb(kNitrogen + unknown);
    FAIL();
  } catch (const ParseError& error) {
    EXPECT_STREQ(error.what(),
                 "a.pdb:2: atom \"X1\" of residue \"UNK\" 2 in chain A has element \"Xx\", which "
                 "has no radius in bondi; give one with --default-radius or a radius file, or "
                 "take --radii none");
  }
  ReadOptions options;
  options.default_radius = "1.25";
  const Reading reading = pdb(kNitrogen + unknown, options);
  EXPECT_EQ(reading.points.weights()[1], 1250);
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_NE(reading.warnings[0].find("line 2"), std::string::npos);
  EXPECT_EQ(reading.radii, "bondi (Bondi 1964, H 1.20; 1.25 for 1 atom)");
  options.default_radius = "big";
  EXPECT_THROW((void)pdb(kNitrogen, options), InputError);
}

TEST(Pdb, HasNoWeightsWithoutRadii) {
  ReadOptions options;
  options.radii = "none";
  const Reading reading = pdb(kNitrogen, options);
  EXPECT_EQ(reading.points.weight_kind(), WeightKind::none);
  EXPECT_EQ(reading.radii, "none");
  EXPECT_FALSE(reading.is_molecule);
}

TEST(Pdb, WarnsOfHydrogensBesideUnitedAtoms) {
  ReadOptions options;
  options.radii = "protor";
  EXPECT_TRUE(pdb(kNitrogen, options).warnings.empty());
  const std::string hydrogen =
      "ATOM      5  H   ALA A   1      10.000   6.000  -6.000  1.00 10.00           H\n";
  EXPECT_EQ(pdb(kNitrogen + hydrogen, options).warnings.size(), 1U);
}

TEST(Pdb, RefusesOptionsOfTables) {
  ReadOptions options;
  options.dimension = 2;
  EXPECT_THROW((void)pdb(kNitrogen, options), InputError);
  options.dimension = 3;
  EXPECT_EQ(pdb(kNitrogen, options).points.size(), 1U);
  options.radius_column = "4";
  EXPECT_THROW((void)pdb(kNitrogen, options), InputError);
}

TEST(Pdb, WithoutAtomsIsEmpty) {
  EXPECT_EQ(pdb("").points.size(), 0U);
  EXPECT_EQ(pdb("HEADER\nEND\n").points.size(), 0U);
}

TEST(Pdb, ReadsLongLinesInLinearTime) {
  EXPECT_EQ(pdb("REMARK " + std::string(1 << 22, 'x') + '\n' + kNitrogen).points.size(), 1U);
}

}  // namespace
}  // namespace orthoball
