// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "orthoball/input/molecule.h"
#include "orthoball/input/read.h"
#include "orthoball/input/source.h"

namespace orthoball {

/// A value of a CIF file.
struct CifValue {
  std::string_view text;     ///< without quotes; empty for "." and "?"
  std::string_view written;  ///< as it stands in the file
  std::size_t line = 0;      ///< 1-based; 0 for no value at all
};

/// The columns of atom_site that are used, those of mmCIF and those of core CIF.
enum class AtomSiteColumn : std::size_t {
  group,
  type_symbol,
  auth_atom,
  label_atom,
  label,
  alternate,
  auth_residue,
  label_residue,
  auth_chain,
  label_chain,
  auth_number,
  label_number,
  insertion,
  cartesian_x,
  cartesian_y,
  cartesian_z,
  fractional_x,
  fractional_y,
  fractional_z,
  occupancy,
  model,
  disorder_assembly,
  disorder_group,
  calculated,
  none,
};

/// Turns the tags and values of a CIF file into atoms as they come by: every row of atom_site
/// becomes an atom as soon as it is complete, and nothing else of the file is stored.
///
/// Atoms come from the first data block that has any. Cartesian coordinates (mmCIF) stay the
/// decimals they are. Fractional ones (core CIF) become Cartesian doubles by the cell of the same
/// block: one cell as listed, in P1.
/// Texts are views into the file, which must outlive the molecule.
class AtomSiteReader {
 public:
  AtomSiteReader(const Source& source, const ReadOptions& options)
      : source_(source), models_(options.molecule.model, "model") {}

  /// A data block begins, which ends the one before it.
  void begin_block(std::string_view name);
  /// A loop begins: its tags follow, then its values.
  void begin_loop();
  /// The next column of the loop.
  void loop_tag(std::string_view tag);
  /// The next value of the loop, row by row.
  /// @throws ParseError for a missing coordinate, or one that is no number.
  void loop_value(const CifValue& value);
  /// The loop is over.
  /// @throws ParseError if the last row is not complete.
  void end_loop();
  /// A tag with one value, outside loops.
  void item(std::string_view tag, const CifValue& value);

  /// The atoms, when all of the file has come by.
  /// @throws ParseError for a model that is not there, a cell that is none.
  [[nodiscard]] Molecule finish();

 private:
  static constexpr std::size_t kColumns = static_cast<std::size_t>(AtomSiteColumn::none);
  using Row = std::array<CifValue, kColumns>;

  [[nodiscard]] const CifValue& at(AtomSiteColumn column) const {
    return row_[static_cast<std::size_t>(column)];
  }
  [[nodiscard]] bool has(AtomSiteColumn column) const;
  [[nodiscard]] bool is_taken() const { return !taken_block_ || *taken_block_ == blocks_; }
  [[nodiscard]] std::string_view text(AtomSiteColumn first, AtomSiteColumn second) const;
  [[nodiscard]] DecimalNumber coordinate(std::size_t axis) const;
  [[nodiscard]] int model() const;
  [[nodiscard]] std::string_view element(const Atom& atom) const;

  void end_block();
  void begin_table(std::size_t line);
  void choose_coordinates(std::size_t line);
  void add_row();
  void place_in_cell();

  const Source& source_;
  ModelChoice models_;
  Molecule molecule_;
  bool is_fractional_ = false;
  std::size_t dummies_ = 0;

  std::size_t blocks_ = 0;
  std::size_t blocks_with_atoms_ = 0;
  std::string_view block_;
  std::optional<std::size_t> taken_block_;  // the first one with atoms
  std::string_view taken_name_;
  bool has_table_ = false;  // in the block at hand
  std::array<CifValue, 6> cell_{};
  std::string_view space_group_;

  std::vector<AtomSiteColumn> columns_;  // of the loop at hand
  bool is_atom_loop_ = false;
  bool is_core_ = false;  // the last tag of atom_site reads _atom_site_x, not _atom_site.x
  std::size_t rows_ = 0;
  std::size_t place_ = 0;  // of the next value in its row
  std::size_t last_line_ = 0;
  Row row_{};
  Row item_row_{};  // items of atom_site outside loops
};

}  // namespace orthoball
