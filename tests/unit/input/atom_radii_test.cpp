// SPDX-License-Identifier: MIT
#include "orthoball/input/atom_radii.h"

#include <gtest/gtest.h>

#include <string>

#include "orthoball/error.h"
#include "orthoball/input/elements.h"
#include "unit/input/temporary_file.h"

namespace orthoball {
namespace {

int elements_with_radius(const AtomRadii& radii) {
  int count = 0;
  for (int number = 1; number <= 118; ++number) {
    if (radii.radius(element_symbol(number), "", "")) ++count;
  }
  return count;
}

TEST(AtomRadii, AreExactDecimals) {
  const AtomRadii bondi("bondi", true);
  const auto carbon = bondi.radius("C", "ALA", "CA");
  ASSERT_TRUE(carbon);
  EXPECT_TRUE(carbon->radius.is_exact);
  EXPECT_EQ(carbon->radius.digits, 17);
  EXPECT_EQ(carbon->radius.exponent, -1);
  EXPECT_EQ(carbon->radius.nearest, 1.7);
}

TEST(AtomRadii, OfBondiAreCompletedByAlvarez) {
  const AtomRadii bondi("bondi", true);
  EXPECT_EQ(bondi.radius("H", "", "")->radius.nearest, 1.2);
  EXPECT_EQ(bondi.radius("D", "", "")->radius.nearest, 1.2);
  EXPECT_EQ(bondi.radius("Zn", "", "")->radius.nearest, 1.39);
  EXPECT_EQ(bondi.radius("Zn", "", "")->source, "Bondi 1964");
  EXPECT_EQ(bondi.radius("Ca", "", "")->radius.nearest, 2.62);
  EXPECT_EQ(bondi.radius("Ca", "", "")->source, "Alvarez 2013");
}

// Neither article has Pm, Po to Ra, and the elements above Es.
TEST(AtomRadii, CoverTheElementsOfTheirArticles) {
  EXPECT_EQ(elements_with_radius(AtomRadii("bondi", true)), 93);
  EXPECT_EQ(elements_with_radius(AtomRadii("alvarez", true)), 93);
  for (const char* element : {"Pm", "Po", "At", "Rn", "Fr", "Ra", "Fm", "Og", "Xx", ""}) {
    EXPECT_FALSE(AtomRadii("bondi", true).radius(element, "", "")) << element;
  }
}

TEST(AtomRadii, OfAlvarezAreHisAlone) {
  const AtomRadii alvarez("alvarez", true);
  EXPECT_EQ(alvarez.radius("C", "", "")->radius.nearest, 1.77);
  EXPECT_EQ(alvarez.radius("U", "", "")->radius.nearest, 2.71);
  EXPECT_EQ(alvarez.radius("Zn", "", "")->source, "Alvarez 2013");
}

TEST(AtomRadii, OfProtorGoByResidueAndAtom) {
  const AtomRadii protor("protor", true);
  const auto radius = [&](const char* residue, const char* atom) {
    return protor.radius(std::string_view(atom).substr(0, 1), residue, atom)->radius.nearest;
  };
  EXPECT_EQ(radius("ALA", "CA"), 1.88);
  EXPECT_EQ(radius("GLY", "C"), 1.61);
  EXPECT_EQ(radius("VAL", "O"), 1.42);
  EXPECT_EQ(radius("VAL", "OXT"), 1.42);
  EXPECT_EQ(radius("PHE", "CZ"), 1.76);
  EXPECT_EQ(radius("TYR", "CZ"), 1.61);
  EXPECT_EQ(radius("TYR", "OH"), 1.46);
  EXPECT_EQ(radius("LYS", "NZ"), 1.64);
  EXPECT_EQ(radius("CYS", "SG"), 1.77);
  EXPECT_EQ(radius("ALA", "CG"), 1.7) << "no such atom: Bondi's";
  EXPECT_EQ(radius("DG", "P"), 1.8);
  EXPECT_EQ(protor.radius("C", "ALA", "CA")->source, "Tsai 1999");
}

// The heavy atoms of the twenty amino acids, with the last oxygen of a chain.
TEST(AtomRadii, OfProtorCoverTheAminoAcids) {
  const AtomRadii protor("protor", true);
  const char* const kAtoms[][2] = {{"ALA", "CB"},
                                   {"ARG", "CB CG CD NE CZ NH1 NH2"},
                                   {"ASN", "CB CG OD1 ND2"},
                                   {"ASP", "CB CG OD1 OD2"},
                                   {"CYS", "CB SG"},
                                   {"GLN", "CB CG CD OE1 NE2"},
                                   {"GLU", "CB CG CD OE1 OE2"},
                                   {"GLY", ""},
                                   {"HIS", "CB CG ND1 CD2 CE1 NE2"},
                                   {"ILE", "CB CG1 CG2 CD1"},
                                   {"LEU", "CB CG CD1 CD2"},
                                   {"LYS", "CB CG CD CE NZ"},
                                   {"MET", "CB CG SD CE"},
                                   {"PHE", "CB CG CD1 CD2 CE1 CE2 CZ"},
                                   {"PRO", "CB CG CD"},
                                   {"SER", "CB OG"},
                                   {"THR", "CB OG1 CG2"},
                                   {"TRP", "CB CG CD1 CD2 NE1 CE2 CE3 CZ2 CZ3 CH2"},
                                   {"TYR", "CB CG CD1 CD2 CE1 CE2 CZ OH"},
                                   {"VAL", "CB CG1 CG2"}};
  for (const auto& [residue, side_chain] : kAtoms) {
    std::istringstream names(std::string("N CA C O OXT ") + side_chain);
    for (std::string name; names >> name;) {
      const auto radius = protor.radius(name.substr(0, 1), residue, name);
      ASSERT_TRUE(radius) << residue << ' ' << name;
      EXPECT_EQ(radius->source, "Tsai 1999") << residue << ' ' << name;
    }
  }
}

TEST(AtomRadii, OfAFileGoByAtomBeforeElement) {
  const TemporaryFile file(".rad", "# my radii\nC 1.90\nALA CB 2.05  # methyl\n\nlp 0\n");
  const AtomRadii radii(file.path(), true);
  EXPECT_EQ(radii.radius("C", "ALA", "CB")->radius.nearest, 2.05);
  EXPECT_EQ(radii.radius("C", "GLY", "CB")->radius.nearest, 1.9);
  EXPECT_EQ(radii.radius("LP", "", "")->radius.nearest, 0.0);
  EXPECT_FALSE(radii.radius("N", "ALA", "N"));
  EXPECT_EQ(radii.radius("C", "", "")->source, file.path());
}

TEST(AtomRadii, RefuseOtherLinesWithTheirNumber) {
  const auto error_of = [](const std::string& bytes) -> std::string {
    const TemporaryFile file(".rad", bytes);
    try {
      const AtomRadii radii(file.path(), true);
    } catch (const ParseError& error) {
      EXPECT_EQ(error.line(), 2U);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(error_of("C 1.7\nN\n").find("ELEMENT radius"), std::string::npos);
  EXPECT_NE(error_of("C 1.7\nA B C 1\n").find("4 words"), std::string::npos);
  EXPECT_NE(error_of("C 1.7\nN one\n").find("\"one\""), std::string::npos);
  try {
    (void)AtomRadii("bondy", true);
    ADD_FAILURE();
  } catch (const ParseError& error) {
    EXPECT_STREQ(error.what(),
                 "bondy: neither a set of radii nor a file; sets are bondi, alvarez, protor and "
                 "none");
  }
}

}  // namespace
}  // namespace orthoball
