// SPDX-License-Identifier: MIT
#include "orthoball/input/elements.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace orthoball {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kElements = 118;
constexpr std::array<std::string_view, kElements + 2> kSymbols = {
    "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",
    "S",  "Cl", "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn",
    "Ga", "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh",
    "Pd", "Ag", "Cd", "In", "Sn", "Sb", "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd",
    "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu", "Hf", "Ta", "W",  "Re",
    "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra", "Ac", "Th",
    "Pa", "U",  "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr", "Rf", "Db",
    "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og", "D",  "T"};

// Residues whose atoms are named by one-letter elements, whatever column the name begins in.
constexpr auto kOneLetterResidues = std::to_array<std::string_view>(
    {"A",   "ACE", "ADE", "ALA", "ARG", "ASH", "ASN", "ASP", "ASX", "C",   "CYM", "CYS", "CYT",
     "CYX", "DA",  "DC",  "DG",  "DI",  "DT",  "DU",  "FOR", "G",   "GLH", "GLN", "GLU", "GLX",
     "GLY", "GUA", "HID", "HIE", "HIP", "HIS", "HSD", "HSE", "HSP", "HYP", "I",   "ILE", "LEU",
     "LYN", "LYS", "MET", "MSE", "NH2", "NMA", "NME", "PHE", "PRO", "PTR", "PYL", "SEC", "SEP",
     "SER", "T",   "THR", "THY", "TPO", "TRP", "TYR", "U",   "URA", "VAL"});

constexpr auto kWaters = std::to_array<std::string_view>(
    {"D2O", "DOD", "H2O",  "HHO",  "HOH",  "OH2",  "OHH", "SOL", "SPC", "T3P",
     "T4P", "TIP", "TIP2", "TIP3", "TIP4", "TIP5", "TP3", "TP4", "TP5", "WAT"});

static_assert(std::is_sorted(kOneLetterResidues.begin(), kOneLetterResidues.end()));
static_assert(std::is_sorted(kWaters.begin(), kWaters.end()));

// Two-letter elements that no atom of another element is named after in practice, so that a name
// outside columns may be taken for them.
constexpr auto kUnmistakable =
    std::to_array<std::string_view>({"Al", "Br", "Cl", "Fe", "Li", "Mg", "Mn", "Se", "Si", "Zn"});

constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
constexpr std::size_t letter_number(char c) {
  return static_cast<std::size_t>(c >= 'a' ? c - 'a' : c - 'A') + 1;
}

// Place in a table of one- and two-letter texts.
constexpr std::size_t kLetterPairs = std::size_t{27} * 27;
constexpr std::size_t letter_pair(std::string_view text) {
  return 27 * letter_number(text[0]) + (text.size() == 2 ? letter_number(text[1]) : 0);
}

// [letter_pair(symbol)]: position in kSymbols plus 1, 0 for none.
constexpr std::array<std::uint8_t, kLetterPairs> kSymbolAt = [] {
  std::array<std::uint8_t, kLetterPairs> table{};
  for (std::size_t i = 0; i < kSymbols.size(); ++i) {
    table[letter_pair(kSymbols[i])] = static_cast<std::uint8_t>(i + 1);
  }
  return table;
}();

// The first run of letters, behind digits and signs.
std::string_view first_letters(std::string_view text) {
  const auto begin = std::find_if(text.begin(), text.end(), is_letter);
  const auto end = std::find_if_not(begin, text.end(), is_letter);
  return text.substr(static_cast<std::size_t>(begin - text.begin()),
                     static_cast<std::size_t>(end - begin));
}

std::string_view one_letter(std::string_view letters) {
  const std::string_view symbol = element_symbol(letters.substr(0, 1));
  return symbol.empty() ? letters.substr(0, 1) : symbol;
}

}  // namespace

std::string_view element_symbol(std::string_view text) {
  if (text.empty() || text.size() > 2 || !std::all_of(text.begin(), text.end(), is_letter)) {
    return {};
  }
  const std::size_t position = kSymbolAt[letter_pair(text)];
  return position == 0 ? std::string_view{} : kSymbols[position - 1];
}

std::string_view element_symbol(int atomic_number) {
  if (atomic_number < 1 || atomic_number > static_cast<int>(kElements)) return {};
  return kSymbols[static_cast<std::size_t>(atomic_number) - 1];
}

bool is_hydrogen(std::string_view symbol) {
  return symbol == "H" || symbol == "D" || symbol == "T";
}

bool is_water(std::string_view residue) {
  return std::binary_search(kWaters.begin(), kWaters.end(), residue);
}

std::string_view element_of_atom(std::string_view name, std::string_view residue,
                                 NameLayout layout) {
  const std::string_view letters = first_letters(name);
  if (letters.empty()) return {};
  const std::string_view one = one_letter(letters);
  const std::string_view two =
      letters.size() < 2 ? std::string_view{} : element_symbol(letters.substr(0, 2));
  if (is_water(residue)) return one;
  if (std::binary_search(kOneLetterResidues.begin(), kOneLetterResidues.end(), residue)) {
    return two == "Se" ? two : one;
  }
  if (two.empty()) return one;
  // An ion is named after its element, as its residue is: "CA" of CA, "FE" of FE2.
  if (letters.size() == 2 && first_letters(residue) == letters) return two;
  if (layout == NameLayout::free) {
    const bool is_certain =
        std::find(kUnmistakable.begin(), kUnmistakable.end(), two) != kUnmistakable.end();
    return is_certain ? two : one;
  }
  // Elements end in the second column; four-letter names of hydrogen begin one column early.
  if (!is_letter(name.front())) return one;
  const bool is_full = name.size() == 4 && name.find(' ') == std::string_view::npos;
  return is_full && is_hydrogen(one) ? one : two;
}

std::string_view element_of_label(std::string_view label) {
  const std::string_view letters = first_letters(label);
  if (letters.empty()) return {};
  if (letters.size() >= 2) {
    const std::string_view two = element_symbol(letters.substr(0, 2));
    // "HO1" is a hydrogen, "Ho1" is holmium.
    const bool is_hydrogen_name = letters[0] == 'H' && letters[1] >= 'A' && letters[1] <= 'Z';
    if (!two.empty() && !is_hydrogen_name) return two;
  }
  return one_letter(letters);
}

}  // namespace orthoball
