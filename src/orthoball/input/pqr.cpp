// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/input/elements.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/molecule.h"

// PQR: the records of the PDB format as words between blanks,
//     ATOM serial name residue [chain] number x y z charge radius
// with a radius for each atom. A line that lacks its radius must not lend its charge to it.

namespace orthoball {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "12", "-3", "12A": a residue's number with its insertion code.
bool is_residue_number(std::string_view text) {
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  return end != text.begin() && text.end() - end <= 1;
}

// "A1000": a chain and a number that fill their columns.
bool is_chain_with_number(std::string_view text) {
  return text.size() > 1 && !is_digit(text.front()) && is_residue_number(text.substr(1));
}

// Splits the words between the residue's name and x into chain and number.
void read_place(const Source& source, std::size_t line, const std::vector<std::string_view>& words,
                Atom& atom) {
  if (words.size() == 11) {
    atom.chain = words[4];
    atom.residue_number = words[5];
    return;
  }
  const bool has_number = words.size() == 10 && is_residue_number(words[4]);
  // Whole numbers for x are residue numbers behind a chain, in a line without a radius.
  const bool has_both = !has_number && words.size() == 10 && is_chain_with_number(words[4]) &&
                        words[5].find('.') != std::string_view::npos;
  if (!has_number && !has_both) {
    throw ParseError(source.name, line,
                     "the line has " + counted(words.size(), "word") +
                         "; 10 are needed, ATOM serial name residue number x y z charge "
                         "radius, or 11 with a chain before the number");
  }
  if (has_both) atom.chain = words[4].substr(0, 1);
  atom.residue_number = words[4].substr(has_both ? 1 : 0);
}

Atom atom_of(const Source& source, std::size_t line, const std::vector<std::string_view>& words) {
  Atom atom;
  read_place(source, line, words, atom);
  const std::size_t x = words.size() - 5;
  atom.position = {number_at(source, line, words[x], "x"),
                   number_at(source, line, words[x + 1], "y"),
                   number_at(source, line, words[x + 2], "z")};
  atom.radius = number_at(source, line, words[x + 4], "radius");
  atom.name = words[2];
  atom.residue = words[3];
  atom.element = element_of_atom(atom.name, atom.residue, NameLayout::free);
  atom.is_hetero = words[0] == "HETATM";
  atom.line = line;
  return atom;
}

}  // namespace

Reading read_pqr(const Source& source, const ReadOptions& options) {
  require_molecule_options(options, "pqr");
  require_text(source);
  Molecule molecule;
  molecule.has_radii = true;
  molecule.has_residues = true;
  ModelChoice models(options.molecule.model, "model");
  int model = 1;
  bool is_over = false;
  Lines lines(source.bytes);
  std::string_view line;
  std::vector<std::string_view> words;
  while (lines.next(line)) {
    split_at_blanks(line, words);
    if (words.empty()) continue;
    if (words[0] == "MODEL" || words[0] == "ENDMDL" || words[0] == "END") is_over = true;
    if (words[0] != "ATOM" && words[0] != "HETATM") continue;
    if (is_over) model = models.next_number();
    is_over = false;
    if (models.takes(model)) molecule.atoms.push_back(atom_of(source, lines.number(), words));
  }
  models.finish(source, molecule.notes);
  return reading_of(source, std::move(molecule), options);
}

}  // namespace orthoball
