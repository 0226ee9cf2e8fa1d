// SPDX-License-Identifier: MIT
#include "orthoball/input/atom_radii.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/input/elements.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/source.h"

namespace orthoball {
namespace {

using namespace std::string_view_literals;

struct ElementRadius {
  std::string_view element;
  int hundredths;  // Angstrom / 100
};

// Tables I and following of the article; hydrogen 1.20 is the value for aliphatic bonds.
constexpr auto kBondi = std::to_array<ElementRadius>(
    {{"H", 120},  {"He", 140}, {"Li", 182}, {"C", 170},  {"N", 155},  {"O", 152},  {"F", 147},
     {"Ne", 154}, {"Na", 227}, {"Mg", 173}, {"Si", 210}, {"P", 180},  {"S", 180},  {"Cl", 175},
     {"Ar", 188}, {"K", 275},  {"Ni", 163}, {"Cu", 140}, {"Zn", 139}, {"Ga", 187}, {"As", 185},
     {"Se", 190}, {"Br", 185}, {"Kr", 202}, {"Pd", 163}, {"Ag", 172}, {"Cd", 158}, {"In", 193},
     {"Sn", 217}, {"Te", 206}, {"I", 198},  {"Xe", 216}, {"Pt", 172}, {"Au", 166}, {"Hg", 155},
     {"Tl", 196}, {"Pb", 202}, {"U", 186}});

constexpr auto kAlvarez = std::to_array<ElementRadius>(
    {{"H", 120},  {"He", 143}, {"Li", 212}, {"Be", 198}, {"B", 191},  {"C", 177},  {"N", 166},
     {"O", 150},  {"F", 146},  {"Ne", 158}, {"Na", 250}, {"Mg", 251}, {"Al", 225}, {"Si", 219},
     {"P", 190},  {"S", 189},  {"Cl", 182}, {"Ar", 183}, {"K", 273},  {"Ca", 262}, {"Sc", 258},
     {"Ti", 246}, {"V", 242},  {"Cr", 245}, {"Mn", 245}, {"Fe", 244}, {"Co", 240}, {"Ni", 240},
     {"Cu", 238}, {"Zn", 239}, {"Ga", 232}, {"Ge", 229}, {"As", 188}, {"Se", 182}, {"Br", 186},
     {"Kr", 225}, {"Rb", 321}, {"Sr", 284}, {"Y", 275},  {"Zr", 252}, {"Nb", 256}, {"Mo", 245},
     {"Tc", 244}, {"Ru", 246}, {"Rh", 244}, {"Pd", 215}, {"Ag", 253}, {"Cd", 249}, {"In", 243},
     {"Sn", 242}, {"Sb", 247}, {"Te", 199}, {"I", 204},  {"Xe", 206}, {"Cs", 348}, {"Ba", 303},
     {"La", 298}, {"Ce", 288}, {"Pr", 292}, {"Nd", 295}, {"Sm", 290}, {"Eu", 287}, {"Gd", 283},
     {"Tb", 279}, {"Dy", 287}, {"Ho", 281}, {"Er", 283}, {"Tm", 279}, {"Yb", 280}, {"Lu", 274},
     {"Hf", 263}, {"Ta", 253}, {"W", 257},  {"Re", 249}, {"Os", 248}, {"Ir", 241}, {"Pt", 229},
     {"Au", 232}, {"Hg", 245}, {"Tl", 247}, {"Pb", 260}, {"Bi", 254}, {"Ac", 280}, {"Th", 293},
     {"Pa", 288}, {"U", 271},  {"Np", 282}, {"Pu", 281}, {"Am", 283}, {"Cm", 305}, {"Bk", 340},
     {"Cf", 305}, {"Es", 270}});

// The types of ProtOr: element, bonds, hydrogens. "ARG CZ" is atom CZ of arginine; * is every one
// of the twenty amino acids.
struct UnitedAtoms {
  int hundredths;
  std::string_view atoms;
};
constexpr auto kProtor = std::to_array<UnitedAtoms>({
    {161,  // C3H0
     "* C;ARG CZ;ASN CG;ASP CG;GLN CD;GLU CD;HIS CG;PHE CG;TRP CG CD2 CE2;TYR CG CZ"},
    {176,  // C3H1
     "HIS CD2 CE1;PHE CD1 CD2 CE1 CE2 CZ;TRP CD1 CE3 CZ2 CZ3 CH2;TYR CD1 CD2 CE1 CE2"},
    {188,  // C4H1, C4H2, C4H3
     "* CA;ALA CB;ARG CB CG CD;ASN CB;ASP CB;CYS CB;GLN CB CG;GLU CB CG;HIS CB;"
     "ILE CB CG1 CG2 CD CD1;LEU CB CG CD1 CD2;LYS CB CG CD CE;MET CB CG CE;PHE CB;PRO CB CG CD;"
     "SER CB;THR CB CG2;TRP CB;TYR CB;VAL CB CG1 CG2"},
    {164,  // N3H0, N3H1, N3H2, N4H3
     "* N;ARG NE NH1 NH2;ASN ND2;GLN NE2;HIS ND1 NE2;LYS NZ;TRP NE1"},
    {142,  // O1H0
     "* O OXT;ASN OD1;ASP OD1 OD2;GLN OE1;GLU OE1 OE2"},
    {146,  // O2H1
     "SER OG;THR OG1;TYR OH"},
    {177,  // S2H0, S2H1
     "CYS SG;MET SD"},
});
constexpr auto kAminoAcids = std::to_array<std::string_view>(
    {"ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY", "HIS", "ILE",
     "LEU", "LYS", "MET", "PHE", "PRO", "SER", "THR", "TRP", "TYR", "VAL"});

constexpr char kBondiSource[] = "Bondi 1964";
constexpr char kAlvarezSource[] = "Alvarez 2013";
constexpr char kProtorSource[] = "Tsai 1999";

DecimalNumber angstrom(int hundredths) { return decimal_number(hundredths, -2); }

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return result;
}

std::string atom_key(std::string_view residue, std::string_view atom) {
  return upper(residue) + ' ' + upper(atom);
}

template <class Visit>
void visit_pieces(std::string_view text, char separator, Visit visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    visit(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

template <class Table>
void add_protor(Table& by_atom) {
  for (const UnitedAtoms& type : kProtor) {
    const AtomRadius radius{angstrom(type.hundredths), kProtorSource};
    visit_pieces(type.atoms, ';', [&](std::string_view residue_atoms) {
      const std::string_view residue = residue_atoms.substr(0, residue_atoms.find(' '));
      visit_pieces(residue_atoms.substr(residue.size() + 1), ' ', [&](std::string_view atom) {
        if (residue != "*") {
          by_atom.insert_or_assign(atom_key(residue, atom), radius);
          return;
        }
        for (const std::string_view each : kAminoAcids) {
          by_atom.insert_or_assign(atom_key(each, atom), radius);
        }
      });
    });
  }
}

}  // namespace

bool AtomRadii::is_named(std::string_view set) {
  return set == "bondi" || set == "alvarez" || set == "protor";
}

AtomRadii::AtomRadii(const std::string& set, bool limited) : name_(set) {
  const auto add = [this](const auto& radii, const char* source) {
    for (const ElementRadius& entry : radii) {
      by_element_.try_emplace(upper(entry.element), AtomRadius{angstrom(entry.hundredths), source});
    }
  };
  if (set == "bondi" || set == "protor") {
    add(kBondi, kBondiSource);
    add(kAlvarez, kAlvarezSource);
    main_source_ = set == "bondi" ? "Bondi 1964, H 1.20" : kProtorSource;
    if (set == "protor") add_protor(by_atom_);
  } else if (set == "alvarez") {
    add(kAlvarez, kAlvarezSource);
    main_source_ = kAlvarezSource;
  } else {
    if (std::error_code error; !std::filesystem::exists(set, error)) {
      throw ParseError(
          set, 0, "neither a set of radii nor a file; sets are bondi, alvarez, protor and none");
    }
    read_file(set, limited);
    main_source_ = "radius file";
  }
}

void AtomRadii::read_file(const std::string& path, bool limited) {
  const Source source = read_source(path, limited);
  require_text(source);
  Lines lines(source.bytes);
  std::string_view line;
  std::vector<std::string_view> fields;
  while (lines.next(line)) {
    split_at_blanks(line.substr(0, line.find('#')), fields);
    if (fields.empty()) continue;
    if (fields.size() > 3 || fields.size() < 2) {
      throw ParseError(path, lines.number(),
                       "the line has " + counted(fields.size(), "word") +
                           "; a line of a radius file reads ELEMENT radius or "
                           "RESIDUE ATOM radius");
    }
    const AtomRadius radius{number_at(source, lines.number(), fields.back(), "radius"), path};
    if (fields.size() == 2) {
      by_element_.insert_or_assign(upper(fields[0]), radius);
    } else {
      by_atom_.insert_or_assign(atom_key(fields[0], fields[1]), radius);
    }
  }
}

std::optional<AtomRadius> AtomRadii::radius(std::string_view element, std::string_view residue,
                                            std::string_view atom) const {
  if (!by_atom_.empty()) {
    if (const auto found = by_atom_.find(atom_key(residue, atom)); found != by_atom_.end()) {
      return found->second;
    }
  }
  auto found = by_element_.find(upper(element));
  if (found == by_element_.end() && is_hydrogen(element)) found = by_element_.find("H"sv);
  if (found == by_element_.end()) return std::nullopt;
  return found->second;
}

}  // namespace orthoball
