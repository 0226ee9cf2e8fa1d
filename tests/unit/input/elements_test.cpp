// SPDX-License-Identifier: MIT
#include "orthoball/input/elements.h"

#include <gtest/gtest.h>

#include <string>

namespace orthoball {
namespace {

TEST(ElementSymbol, IsFoundInAnyCase) {
  EXPECT_EQ(element_symbol("CA"), "Ca");
  EXPECT_EQ(element_symbol("zn"), "Zn");
  EXPECT_EQ(element_symbol("c"), "C");
  EXPECT_EQ(element_symbol("D"), "D");
  for (const char* text : {"", "Xx", "C1", "LP", "Car", " C", "1"}) {
    EXPECT_EQ(element_symbol(text), "") << text;
  }
}

TEST(ElementSymbol, IsThatOfTheAtomicNumber) {
  EXPECT_EQ(element_symbol(1), "H");
  EXPECT_EQ(element_symbol(26), "Fe");
  EXPECT_EQ(element_symbol(118), "Og");
  for (const int number : {-1, 0, 119, 120}) EXPECT_EQ(element_symbol(number), "") << number;
}

TEST(ElementSymbol, RoundsTripForEveryElement) {
  for (int number = 1; number <= 118; ++number) {
    const std::string symbol(element_symbol(number));
    EXPECT_EQ(element_symbol(symbol), symbol);
  }
}

TEST(Hydrogen, HasThreeIsotopes) {
  EXPECT_TRUE(is_hydrogen("H") && is_hydrogen("D") && is_hydrogen("T"));
  EXPECT_FALSE(is_hydrogen("He") || is_hydrogen("") || is_hydrogen("C"));
}

TEST(Water, IsKnownByItsUsualNames) {
  for (const char* name : {"HOH", "WAT", "DOD", "H2O", "TIP3", "SOL", "SPC"}) {
    EXPECT_TRUE(is_water(name)) << name;
  }
  for (const char* name : {"", "OH", "ALA", "MET", "hoh"}) EXPECT_FALSE(is_water(name)) << name;
}

TEST(ElementOfAtom, FollowsTheColumnsOfPdbNames) {
  const auto element = [](const char* name, const char* residue) {
    return element_of_atom(name, residue, NameLayout::columns);
  };
  EXPECT_EQ(element(" CA ", "ALA"), "C");
  EXPECT_EQ(element("CA  ", "CA"), "Ca");
  EXPECT_EQ(element("CA  ", "ALA"), "C") << "a name that begins one column early";
  EXPECT_EQ(element(" CA ", "CA"), "Ca") << "an ion whose name begins one column late";
  EXPECT_EQ(element("HH31", "ACE"), "H");
  EXPECT_EQ(element("HG11", "LIG"), "H") << "not mercury";
  EXPECT_EQ(element("1HB ", "ALA"), "H");
  EXPECT_EQ(element("HG  ", "HG"), "Hg");
  EXPECT_EQ(element("HG  ", "CYS"), "H");
  EXPECT_EQ(element("CL1 ", "LIG"), "Cl");
  EXPECT_EQ(element(" CL1", "LIG"), "C") << "carbon: column 13 is blank";
  EXPECT_EQ(element("CH3 ", "NME"), "C");
  EXPECT_EQ(element("SE  ", "MSE"), "Se");
  EXPECT_EQ(element(" O5'", "DG"), "O");
  EXPECT_EQ(element("FE  ", "HEM"), "Fe");
  EXPECT_EQ(element(" X1 ", "UNK"), "X");
  EXPECT_EQ(element("    ", "UNK"), "");
  EXPECT_EQ(element("", "UNK"), "");
}

TEST(ElementOfAtom, TakesTwoLettersOfAFreeNameOnlyWhenCertain) {
  const auto element = [](const char* name, const char* residue) {
    return element_of_atom(name, residue, NameLayout::free);
  };
  EXPECT_EQ(element("CA", "ALA"), "C");
  EXPECT_EQ(element("CA", "CA"), "Ca");
  EXPECT_EQ(element("CA", "LIG"), "C");
  EXPECT_EQ(element("CL1", "LIG"), "Cl");
  EXPECT_EQ(element("ZN", "ZN2"), "Zn");
  EXPECT_EQ(element("HG", "SER"), "H");
  EXPECT_EQ(element("H2", "TIP3"), "H");
}

TEST(ElementOfLabel, IsItsBeginning) {
  EXPECT_EQ(element_of_label("Si4+"), "Si");
  EXPECT_EQ(element_of_label("CL1"), "Cl");
  EXPECT_EQ(element_of_label("C1A"), "C");
  EXPECT_EQ(element_of_label("OW2"), "O");
  EXPECT_EQ(element_of_label("HO1"), "H");
  EXPECT_EQ(element_of_label("Ho1"), "Ho");
  EXPECT_EQ(element_of_label("CoA1"), "Co");
  EXPECT_EQ(element_of_label("12"), "");
}

}  // namespace
}  // namespace orthoball
