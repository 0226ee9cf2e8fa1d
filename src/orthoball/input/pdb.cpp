// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/elements.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/molecule.h"

// The fixed columns of the PDB format, version 3.3, and of its older versions, in which columns 73
// to 80 number the lines. Serial numbers are not used, so hybrid-36 and overflowing ones are fine;
// B factors are not used either, and an occupancy that is no number counts as 1.

namespace orthoball {
namespace {

// Columns `first` to `last`, counted from 1, of a line that may end before them.
std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  if (line.size() < first) return {};
  return line.substr(first - 1, last - first + 1);
}

bool is_atom(std::string_view line) {
  if (columns(line, 1, 6) == "HETATM") return true;
  // Serial numbers above 99999 may reach into columns 5 and 6.
  return columns(line, 1, 4) == "ATOM" && line.size() > 6 &&
         std::all_of(line.begin() + 4, line.begin() + 6,
                     [](char c) { return c == ' ' || (c >= '0' && c <= '9'); });
}

std::string_view element_of(std::string_view line, std::string_view residue) {
  const std::string_view field = trimmed(columns(line, 77, 78));
  const bool is_symbol = !field.empty() && std::all_of(field.begin(), field.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  if (!is_symbol) return element_of_atom(columns(line, 13, 16), residue, NameLayout::columns);
  const std::string_view symbol = element_symbol(field);
  return symbol.empty() ? field : symbol;
}

void read_position(const Source& source, std::size_t number, std::string_view line, Atom& atom) {
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  constexpr std::size_t kLast = 54;  // column in which z ends
  const std::size_t length = line.find_last_not_of(" \t") + 1;
  if (length < kLast) {
    throw ParseError(source.name, number,
                     "the line ends at column " + std::to_string(length) +
                         "; x, y, z are needed in columns 31-38, 39-46, 47-54");
  }
  if (line[29] != ' ') {
    throw ParseError(source.name, number,
                     "column 30 is not blank; x, y, z are needed in columns 31-38, 39-46, 47-54");
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view field = trimmed(columns(line, 31 + 8 * axis, 38 + 8 * axis));
    atom.position[axis] = number_at(source, number, field, kAxes[axis]);
  }
}

Atom atom_of(const Source& source, std::size_t number, std::string_view line) {
  Atom atom;
  read_position(source, number, line, atom);
  const DecimalParse occupancy = parse_decimal(trimmed(columns(line, 55, 60)));
  if (occupancy.fault == DecimalFault::none) atom.occupancy = occupancy.number.nearest;
  atom.name = trimmed(columns(line, 13, 16));
  atom.alternate = trimmed(columns(line, 17, 17));
  atom.residue = trimmed(columns(line, 18, 21));  // four letters in files of CHARMM
  atom.chain = trimmed(columns(line, 22, 22));
  atom.residue_number = trimmed(columns(line, 23, 26));
  atom.insertion = trimmed(columns(line, 27, 27));
  atom.element = element_of(line, atom.residue);
  atom.is_hetero = line.front() == 'H';
  atom.line = number;
  return atom;
}

// Models are what stands between MODEL and ENDMDL, and the parts that END separates.
class ModelNumber {
 public:
  explicit ModelNumber(const ModelChoice& models) : models_(models) {}

  void read(std::string_view line) {
    const std::string_view record = trimmed(columns(line, 1, 6));
    if (record == "MODEL") {
      const std::string_view text = trimmed(line.substr(std::min<std::size_t>(line.size(), 6)));
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number_);
      const bool is_number = error == std::errc() && end == text.data() + text.size();
      if (!is_number || models_.has_seen(number_)) number_ = models_.next_number();
      is_over_ = false;
    } else if (record == "ENDMDL" || record == "END") {
      is_over_ = true;
    }
  }

  // Of the atom that follows.
  [[nodiscard]] int number() {
    if (is_over_) number_ = models_.next_number();
    is_over_ = false;
    return number_;
  }

 private:
  const ModelChoice& models_;
  int number_ = 1;
  bool is_over_ = false;
};

}  // namespace

Reading read_pdb(const Source& source, const ReadOptions& options) {
  require_molecule_options(options, "pdb");
  require_text(source);
  Molecule molecule;
  molecule.has_residues = true;
  molecule.atoms.reserve(source.bytes.size() / 80);  // if all lines are atoms
  ModelChoice models(options.molecule.model, "model");
  ModelNumber model(models);
  Lines lines(source.bytes);
  std::string_view line;
  while (lines.next(line)) {
    if (!is_atom(line)) {
      model.read(line);
    } else if (models.takes(model.number())) {
      molecule.atoms.push_back(atom_of(source, lines.number(), line));
    }
  }
  models.finish(source, molecule.notes);
  return reading_of(source, std::move(molecule), options);
}

}  // namespace orthoball
