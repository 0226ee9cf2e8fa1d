// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/input/formats.h"

namespace orthoball {
namespace {

using Strings = std::vector<std::string>;

const std::string kColumns =
    "loop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
    "_atom_site.label_alt_id\n_atom_site.auth_comp_id\n_atom_site.auth_asym_id\n"
    "_atom_site.auth_seq_id\n_atom_site.pdbx_PDB_ins_code\n_atom_site.Cartn_x\n"
    "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n"
    "_atom_site.pdbx_PDB_model_num\n";
const std::string kHead = "data_x\n" + kColumns;  // lines 1 to 15

const std::string kCell =
    "_cell_length_a 10.0(2)\n_cell_length_b 10\n_cell_length_c 20\n_cell_angle_alpha 90\n"
    "_cell_angle_beta 90\n_cell_angle_gamma 90.00(1)\n";
const std::string kFractional =
    "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n";

Reading cif(const std::string& text, const ReadOptions& options = {}) {
  return read_cif({"a.cif", text}, options);
}

std::string error_of(const std::string& text) {
  try {
    (void)cif(text);
  } catch (const ParseError& error) {
    return error.what();
  }
  return "";
}

bool begins_with(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

TEST(MmCif, IsReadAsExactDecimals) {
  const Reading reading = cif(kHead +
                              "ATOM N N . ALA A 1 ? 11.104 6.134 -6.504 1.00 1\n"
                              "ATOM C \"C5'\" . ALA A 1 B 1.5 2 3(4) 1.00 1\n");
  ASSERT_EQ(reading.points.size(), 2U);
  EXPECT_EQ(reading.points.decimals(), 3);
  EXPECT_EQ(reading.points.coordinates()[2], -6504);
  EXPECT_EQ(reading.points.coordinates()[5], 3000);
  EXPECT_EQ(reading.points.weights()[0], 1550);
  EXPECT_EQ(reading.labels.atom, (Strings{"N", "C5'"}));
  EXPECT_EQ(reading.labels.residue, (Strings{"ALA", "ALA"}));
  EXPECT_EQ(reading.labels.residue_id, (Strings{"1", "1B"}));
  EXPECT_EQ(reading.labels.chain, (Strings{"A", "A"}));
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{16, 17}));
  EXPECT_TRUE(reading.notes.empty());
}

TEST(MmCif, MayBreakRowsAndQuoteValues) {
  const Reading reading = cif(kHead +
                              "ATOM # comment\n'C' CA\n;\n;\n\"ALA\" A 1 ?\n1\n2\n3 1.0 1\n"
                              "ATOM N N . ALA A 1 ? 4 5 6 1.0 1");
  ASSERT_EQ(reading.points.size(), 2U);
  EXPECT_EQ(reading.points.coordinate(0, 2), 3.0);
  EXPECT_EQ(reading.points.coordinate(1, 0), 4.0);
}

TEST(MmCif, MayGiveItsOnlyAtomWithoutALoop) {
  const Reading reading =
      cif("data_x\n_atom_site.Cartn_x 1.5\n_atom_site.Cartn_y 2\n_atom_site.Cartn_z 3\n"
          "_atom_site.type_symbol C\n");
  ASSERT_EQ(reading.points.size(), 1U);
  EXPECT_EQ(reading.points.coordinate(0, 0), 1.5);
}

TEST(MmCif, TakesTheFirstBlockWithAtoms) {
  const std::string loop =
      "loop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  const Reading reading =
      cif("data_none\n_x.y 1\ndata_a\n" + loop + "C 1 2 3\ndata_b\n" + loop + "N 4 5 6\nN 7 8 9\n");
  EXPECT_EQ(reading.labels.element, Strings{"C"});
  EXPECT_EQ(reading.notes,
            Strings{"data block \"a\" read, the first of 2 with atoms among 3 blocks"});
}

TEST(MmCif, TakesTheFirstModelHighestOccupancyAndNoWaters) {
  const Reading reading = cif(kHead +
                              "ATOM C CA . ALA A 1 ? 1 1 1 1.00 1\n"
                              "ATOM C CB A ALA A 1 ? 2 1 1 0.30 1\n"
                              "ATOM C CB B ALA A 1 ? 3 1 1 0.70 1\n"
                              "HETATM O O . HOH A 2 ? 9 9 9 1.00 1\n"
                              "ATOM C CA . ALA A 1 ? 1 1 2 1.00 2\n");
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{16, 18}));
  EXPECT_EQ(reading.notes.size(), 3U);
}

TEST(MmCif, NamesLineAndItemOfAFault) {
  EXPECT_TRUE(begins_with(error_of(kHead + "ATOM N N . ALA A 1 ? ? 6 -6 1 1\n"),
                          "a.cif:16: _atom_site.Cartn_x is \"?\""));
  EXPECT_TRUE(begins_with(error_of(kHead + "ATOM N N . ALA A 1 ? 1 '2' . 1 1\n"),
                          "a.cif:16: _atom_site.Cartn_z is \".\""));
  EXPECT_TRUE(begins_with(error_of(kHead + "ATOM N N . ALA A 1 ? 1 2 3x 1 1\n"),
                          "a.cif:16: _atom_site.Cartn_z is \"3x\""));
  EXPECT_TRUE(begins_with(error_of(kHead + "ATOM N N . ALA A 1 ? 1 2 3 1 one\n"),
                          "a.cif:16: the model number is \"one\""));
  EXPECT_TRUE(begins_with(error_of(kHead + "ATOM N N . ALA A 1 ? 1 2 3 1 1\nATOM N\n"),
                          "a.cif:17: the last row of the loop has 2 values; 13 are needed"));
  EXPECT_TRUE(begins_with(error_of("data_x\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n1 2\n"),
                          "a.cif:5: _atom_site.Cartn_z is missing"));
  EXPECT_TRUE(begins_with(error_of(kHead + "ATOM N N . ALA A 1 ? 1 2 3 1 1\n" + kColumns +
                                   "ATOM N N . ALA A 1 ? 1 2 3 1 1\n"),
                          "a.cif:31: a second list of atoms"));
}

TEST(MmCif, NamesTheLineOfASyntaxFault) {
  EXPECT_TRUE(begins_with(error_of(kHead + "ATOM 'N N\n"), "a.cif:16: unterminated 'string'"));
  EXPECT_TRUE(begins_with(error_of("data_x\n_a.b\n;text\nmore\n"), "a.cif:3: the text field"));
  EXPECT_TRUE(begins_with(error_of("data_x\n_a.b 1\n_a.c\n"), "a.cif:3: "));
  EXPECT_TRUE(begins_with(error_of("HEADER x\nATOM\n"), "a.cif:1: expected block header"));
  EXPECT_TRUE(begins_with(error_of("data_x\n_a.b 1 2\n"), "a.cif:2: this is not CIF"));
}

TEST(MmCif, EndsLinesInAnyWay) {
  std::string text = kHead + "ATOM N N . ALA A 1 ? 1 2 3 1 1\nATOM N N . ALA A 1 ? ? 2 3 1 1\n";
  for (char& c : text) c = c == '\n' ? '\r' : c;
  EXPECT_TRUE(begins_with(error_of(text), "a.cif:17: "));
}

TEST(MmCif, WithoutAtomsIsEmpty) {
  EXPECT_EQ(cif("").points.size(), 0U);
  EXPECT_EQ(cif("# nothing\n").points.size(), 0U);
  EXPECT_EQ(cif("data_x\n_a.b 1\n").points.size(), 0U);
}

TEST(CoreCif, IsOneCellInP1AsDoubles) {
  const Reading reading = cif("data_x\n" + kFractional + "C1 0.1250(3) 0.25(1) -0.5\n" + kCell);
  ASSERT_EQ(reading.points.size(), 1U);
  EXPECT_EQ(reading.points.decimals(), std::nullopt);
  EXPECT_EQ(reading.points.coordinate(0, 0), 1.25);
  EXPECT_EQ(reading.points.coordinate(0, 1), 2.5);
  EXPECT_EQ(reading.points.coordinate(0, 2), -10.0);
  EXPECT_EQ(reading.labels.element, Strings{"C"});
  EXPECT_EQ(reading.labels.atom, Strings{"C1"});
  ASSERT_EQ(reading.notes.size(), 1U);
  EXPECT_NE(reading.notes[0].find("P1"), std::string::npos);
  EXPECT_TRUE(reading.warnings.empty());
}

TEST(CoreCif, WarnsOfSymmetryThatIsNotApplied) {
  const std::string atoms = kFractional + "O1 0 0 0\n";
  EXPECT_EQ(
      cif("data_x\n_symmetry_space_group_name_H-M 'F m -3 c'\n" + kCell + atoms).warnings.size(),
      1U);
  EXPECT_EQ(cif("data_x\n_symmetry_space_group_name_H-M 'P 1'\n" + kCell + atoms).warnings.size(),
            0U);
}

TEST(CoreCif, NeedsACell) {
  EXPECT_NE(error_of("data_x\n" + kFractional + "O1 0 0 0\n").find("_cell_length_a is missing"),
            std::string::npos);
  std::string flat = kCell;
  flat.replace(flat.find("20"), 2, "-2");
  EXPECT_TRUE(begins_with(error_of("data_x\n" + flat + kFractional + "O1 0 0 0\n"),
                          "a.cif:2: no cell has these lengths"));
  EXPECT_NE(error_of("data_a\n" + kCell + "data_x\n" + kFractional + "O1 0 0 0\n"), "")
      << "the cell of another block";
}

TEST(CoreCif, TakesOneGroupOfADisorderedAssembly) {
  const Reading reading =
      cif("data_x\n" + kCell +
          "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
          "_atom_site_occupancy\n_atom_site_disorder_assembly\n_atom_site_disorder_group\n"
          "C1 0 0 0 1 . .\nC2A 0 0 .1 0.4(1) A 1\nC2B 0 0 .2 0.6(1) A 2\nO3B 0 .1 0 0.6 A 2\n");
  EXPECT_EQ(reading.labels.atom, (Strings{"C1", "C2B", "O3B"}));
  EXPECT_TRUE(reading.labels.chain.empty());
}

TEST(CoreCif, LeavesDummyAtomsOut) {
  const Reading reading =
      cif("data_x\n" + kCell +
          "loop_\n_atom_site_label\n_atom_site_calc_flag\n_atom_site_fract_x\n"
          "_atom_site_fract_y\n_atom_site_fract_z\nCg1 dum 0 0 0\nC2 d 0 0 .1\n");
  EXPECT_EQ(reading.labels.atom, Strings{"C2"});
  EXPECT_EQ(reading.notes[0], "dummy atoms left out: 1");
}

}  // namespace
}  // namespace orthoball
