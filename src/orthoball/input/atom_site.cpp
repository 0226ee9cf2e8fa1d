// SPDX-License-Identifier: MIT
#include "orthoball/input/atom_site.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/crystal_cell.h"
#include "orthoball/input/elements.h"
#include "orthoball/input/fields.h"

namespace orthoball {
namespace {

using Column = AtomSiteColumn;

// [AtomSiteColumn]: the item's name behind "_atom_site." or "_atom_site_".
constexpr std::array<std::string_view, static_cast<std::size_t>(Column::none)> kColumnNames = {
    "group_PDB",         "type_symbol",    "auth_atom_id",
    "label_atom_id",     "label",          "label_alt_id",
    "auth_comp_id",      "label_comp_id",  "auth_asym_id",
    "label_asym_id",     "auth_seq_id",    "label_seq_id",
    "pdbx_PDB_ins_code", "Cartn_x",        "Cartn_y",
    "Cartn_z",           "fract_x",        "fract_y",
    "fract_z",           "occupancy",      "pdbx_PDB_model_num",
    "disorder_assembly", "disorder_group", "calc_flag",
};

// Names are compared in lower case, with "." read as "_": core CIF writes _cell_length_a, mmCIF
// _cell.length_a.
constexpr std::string_view kCategory = "_atom_site";
constexpr std::array<std::string_view, 6> kCellNames = {"_cell_length_a",   "_cell_length_b",
                                                        "_cell_length_c",   "_cell_angle_alpha",
                                                        "_cell_angle_beta", "_cell_angle_gamma"};
constexpr std::array<std::string_view, 3> kSpaceGroupNames = {
    "_symmetry_space_group_name_h-m", "_space_group_name_h-m_alt", "_space_group_name_h-m"};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

bool is_same_name(std::string_view tag, std::string_view name) {
  const auto folded = [](char c) { return c == '.' ? '_' : lower(c); };
  return tag.size() == name.size() &&
         std::equal(tag.begin(), tag.end(), name.begin(),
                    [&](char a, char b) { return folded(a) == folded(b); });
}

bool is_core_tag(std::string_view tag) {
  return tag.size() > kCategory.size() && tag[kCategory.size()] == '_';
}

Column column_of(std::string_view tag) {
  if (tag.size() <= kCategory.size() || !is_same_name(tag.substr(0, kCategory.size()), kCategory) ||
      (tag[kCategory.size()] != '.' && tag[kCategory.size()] != '_')) {
    return Column::none;
  }
  const std::string_view name = tag.substr(kCategory.size() + 1);
  const auto found = std::find_if(kColumnNames.begin(), kColumnNames.end(),
                                  [&](std::string_view each) { return is_same_name(name, each); });
  return static_cast<Column>(found - kColumnNames.begin());
}

Column operator+(Column first, std::size_t offset) {
  return static_cast<Column>(static_cast<std::size_t>(first) + offset);
}

bool is_coordinate(Column column) {
  return column >= Column::cartesian_x && column <= Column::fractional_z;
}

std::string item_name(Column column, bool is_core) {
  return std::string(kCategory) + (is_core ? '_' : '.') +
         std::string(kColumnNames[static_cast<std::size_t>(column)]);
}

// "1.234(5)" without its standard uncertainty.
std::string_view without_uncertainty(std::string_view text) {
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos || text.back() != ')' || text.size() < open + 3) return text;
  const std::string_view digits = text.substr(open + 1, text.size() - open - 2);
  const bool is_number =
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_number ? text.substr(0, open) : text;
}

}  // namespace

void AtomSiteReader::begin_block(std::string_view name) {
  end_block();
  ++blocks_;
  block_ = name;
  if (taken_block_) return;
  cell_ = {};
  space_group_ = {};
}

void AtomSiteReader::begin_loop() {
  columns_.clear();
  is_atom_loop_ = false;
  rows_ = 0;
  place_ = 0;
}

void AtomSiteReader::loop_tag(std::string_view tag) {
  columns_.push_back(column_of(tag));
  if (!is_coordinate(columns_.back())) return;
  is_atom_loop_ = true;
  is_core_ = is_core_tag(tag);
}

void AtomSiteReader::loop_value(const CifValue& value) {
  last_line_ = value.line;
  if (is_atom_loop_) {
    if (rows_ == 0 && place_ == 0) begin_table(value.line);
    if (place_ == 0) row_ = {};
    if (const Column column = columns_[place_]; column != Column::none) {
      row_[static_cast<std::size_t>(column)] = value;
    }
  }
  if (++place_ < columns_.size()) return;
  place_ = 0;
  ++rows_;
  if (is_atom_loop_ && is_taken()) add_row();
}

void AtomSiteReader::end_loop() {
  if (place_ == 0) return;
  throw ParseError(source_.name, last_line_,
                   "the last row of the loop has " + std::to_string(place_) + " values; " +
                       std::to_string(columns_.size()) + " are needed, one for each column");
}

void AtomSiteReader::item(std::string_view tag, const CifValue& value) {
  if (const Column column = column_of(tag); column != Column::none) {
    item_row_[static_cast<std::size_t>(column)] = value;
    if (is_coordinate(column)) is_core_ = is_core_tag(tag);
    return;
  }
  if (!is_taken()) return;
  for (std::size_t i = 0; i < kCellNames.size(); ++i) {
    if (is_same_name(tag, kCellNames[i])) cell_[i] = value;
  }
  for (const std::string_view name : kSpaceGroupNames) {
    if (is_same_name(tag, name)) space_group_ = value.text;
  }
}

Molecule AtomSiteReader::finish() {
  end_block();
  models_.finish(source_, molecule_.notes);
  if (blocks_ > 1 && taken_block_) {
    molecule_.notes.push_back("data block " + quoted(taken_name_) + " read, the first of " +
                              std::to_string(blocks_with_atoms_) + " with atoms among " +
                              std::to_string(blocks_) + " blocks");
  }
  if (dummies_ != 0) {
    molecule_.notes.push_back("dummy atoms left out: " + std::to_string(dummies_));
  }
  if (is_fractional_ && !molecule_.atoms.empty()) place_in_cell();
  return std::move(molecule_);
}

// A block may give its only atom by items instead of a loop.
void AtomSiteReader::end_block() {
  columns_.clear();
  std::size_t line = 0;
  for (std::size_t i = 0; i < kColumns; ++i) {
    if (item_row_[i].line == 0) continue;
    columns_.push_back(static_cast<Column>(i));
    if (is_coordinate(columns_.back())) line = std::max(line, item_row_[i].line);
  }
  if (line != 0) {
    begin_table(line);
    row_ = item_row_;
    if (is_taken()) add_row();
  }
  item_row_ = {};
  has_table_ = false;
}

void AtomSiteReader::begin_table(std::size_t line) {
  if (has_table_) {
    throw ParseError(source_.name, line,
                     "a second list of atoms in the same data block; one is needed");
  }
  has_table_ = true;
  ++blocks_with_atoms_;
  if (taken_block_) return;
  taken_block_ = blocks_;
  taken_name_ = block_;
  choose_coordinates(line);
  molecule_.has_residues = has(Column::auth_residue) || has(Column::label_residue);
}

bool AtomSiteReader::has(Column column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

void AtomSiteReader::choose_coordinates(std::size_t line) {
  is_fractional_ =
      !has(Column::cartesian_x) && !has(Column::cartesian_y) && !has(Column::cartesian_z);
  const Column x = is_fractional_ ? Column::fractional_x : Column::cartesian_x;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (has(x + axis)) continue;
    throw ParseError(
        source_.name, line,
        item_name(x + axis, is_core_) + " is missing; all three coordinates are needed");
  }
}

std::string_view AtomSiteReader::text(Column first, Column second) const {
  return at(first).text.empty() ? at(second).text : at(first).text;
}

DecimalNumber AtomSiteReader::coordinate(std::size_t axis) const {
  const Column column = (is_fractional_ ? Column::fractional_x : Column::cartesian_x) + axis;
  const CifValue& value = at(column);
  const std::string_view text =
      value.text.empty() ? value.written : without_uncertainty(value.text);
  const DecimalParse parse = parse_decimal(text);
  if (parse.fault == DecimalFault::none) return parse.number;
  return number_at(source_, value.line, text, item_name(column, is_core_));
}

int AtomSiteReader::model() const {
  const CifValue& value = at(Column::model);
  int number = 1;
  if (value.text.empty()) return number;
  const char* const end = value.text.data() + value.text.size();
  const auto result = std::from_chars(value.text.data(), end, number);
  if (result.ec == std::errc() && result.ptr == end) return number;
  throw ParseError(source_.name, value.line,
                   "the model number is " + quoted(value.text) + "; a whole number is needed");
}

std::string_view AtomSiteReader::element(const Atom& atom) const {
  const std::string_view symbol = at(Column::type_symbol).text;
  if (symbol.empty()) {
    return molecule_.has_residues ? element_of_atom(atom.name, atom.residue, NameLayout::free)
                                  : element_of_label(atom.name);
  }
  // "Si4+" is Si; what is no element stays as it is.
  const auto end = std::find_if_not(symbol.begin(), symbol.end(), is_letter);
  const std::string_view element =
      element_symbol(symbol.substr(0, static_cast<std::size_t>(end - symbol.begin())));
  return element.empty() ? symbol : element;
}

void AtomSiteReader::add_row() {
  if (at(Column::calculated).text == "dum") {
    ++dummies_;
    return;
  }
  if (!models_.takes(model())) return;
  Atom& atom = molecule_.atoms.emplace_back();
  for (std::size_t axis = 0; axis < 3; ++axis) atom.position[axis] = coordinate(axis);
  atom.line = at(is_fractional_ ? Column::fractional_x : Column::cartesian_x).line;
  const DecimalParse occupancy = parse_decimal(without_uncertainty(at(Column::occupancy).text));
  if (occupancy.fault == DecimalFault::none) atom.occupancy = occupancy.number.nearest;
  atom.is_hetero = at(Column::group).text == "HETATM";
  if (molecule_.has_residues) {
    atom.name = text(Column::auth_atom, Column::label_atom);
    atom.residue = text(Column::auth_residue, Column::label_residue);
    atom.residue_number = text(Column::auth_number, Column::label_number);
    atom.insertion = at(Column::insertion).text;
    atom.chain = text(Column::auth_chain, Column::label_chain);
    atom.alternate = at(Column::alternate).text;
  } else {
    // The alternates of core CIF are the groups of a disordered assembly.
    atom.name = text(Column::label, Column::label_atom);
    atom.chain = at(Column::disorder_assembly).text;
    atom.residue = at(Column::disorder_group).text;
    atom.alternate = atom.residue;
  }
  atom.element = element(atom);
}

void AtomSiteReader::place_in_cell() {
  std::array<double, 6> numbers{};
  for (std::size_t i = 0; i < 6; ++i) {
    if (cell_[i].text.empty()) {
      throw ParseError(source_.name, molecule_.atoms.front().line,
                       "the coordinates are fractional and " + std::string(kCellNames[i]) +
                           " is missing; all six numbers of the cell are needed");
    }
    numbers[i] =
        number_at(source_, cell_[i].line, without_uncertainty(cell_[i].text), kCellNames[i])
            .nearest;
  }
  const auto cell =
      CrystalCell::of({numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]});
  if (!cell) {
    throw ParseError(source_.name, cell_[0].line,
                     "no cell has these lengths and angles; positive lengths are needed, and "
                     "angles that leave it a volume");
  }
  for (Atom& atom : molecule_.atoms) {
    const std::array<double, 3> position = cell->cartesian(
        {atom.position[0].nearest, atom.position[1].nearest, atom.position[2].nearest});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(position[axis])) {
        throw ParseError(source_.name, atom.line,
                         "the position in the cell is out of range; numbers must be below 1.8e308 "
                         "in size");
      }
      atom.position[axis] = {.nearest = position[axis] + 0.0, .is_exact = false};  // never -0
    }
  }
  const std::string symmetry =
      space_group_.empty() ? "symmetry" : "the symmetry " + quoted(space_group_);
  molecule_.notes.push_back("fractional coordinates: the atoms of one unit cell as listed (P1); " +
                            symmetry + " and periodicity are not applied");
  std::string group(space_group_);
  group.erase(std::remove(group.begin(), group.end(), ' '), group.end());
  if (!group.empty() && !is_same_name(group, "P1")) {
    molecule_.warnings.push_back("only the atoms that are listed are read, " + symmetry +
                                 " would make more; expand the file to P1 for the whole cell");
  }
}

}  // namespace orthoball
