// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "orthoball/input/decimal.h"

namespace orthoball {

/// A radius in Angstrom, exact, and who gives it: "Bondi 1964", "Alvarez 2013", "Tsai 1999", or the
/// path of a file.
struct AtomRadius {
  DecimalNumber radius;
  std::string source;
};

/// Radii of atoms by element, or by residue and atom name.
///
/// The named sets are:
/// - `bondi`: van der Waals radii of Bondi, with 1.20 for hydrogen; Alvarez where Bondi has none.
///   @cite bondi_1964_volumes @cite alvarez_2013_cartography
/// - `alvarez`: Alvarez alone.
/// - `protor`: united atoms of the twenty amino acids, hydrogens contained, by Tsai and others
///   (both oxygens of a carboxylate without hydrogen); `bondi` for all other atoms.
///   @cite tsai_1999_packing
/// Any other name is the path of a file with a line `ELEMENT radius` or `RESIDUE ATOM radius` for
/// each radius, the latter going before the former; blank lines and what follows # are skipped.
class AtomRadii {
 public:
  /// @param limited  refuse a file beyond the limits of source.h.
  /// @throws ParseError for a file that cannot be opened or has another kind of line.
  AtomRadii(const std::string& set, bool limited);

  /// Whether `set` is one of the named sets, no file.
  [[nodiscard]] static bool is_named(std::string_view set);

  /// The radius of an atom, empty where the set has none. Elements in any case; deuterium and
  /// tritium are hydrogen unless the set names them. O(log of the set's size).
  [[nodiscard]] std::optional<AtomRadius> radius(std::string_view element, std::string_view residue,
                                                 std::string_view atom) const;

  /// The set's name with its main source: "bondi", "Bondi 1964, H 1.20".
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& main_source() const { return main_source_; }

 private:
  using Table = std::map<std::string, AtomRadius, std::less<>>;

  void read_file(const std::string& path, bool limited);

  std::string name_;
  std::string main_source_;
  Table by_element_;  // upper case
  Table by_atom_;     // "RESIDUE ATOM", upper case
};

}  // namespace orthoball
