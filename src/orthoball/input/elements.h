// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace orthoball {

/// The symbol of an element as the periodic table writes it, for a symbol in any case: "CA" and
/// "ca" are "Ca". D and T count as symbols. Empty for anything else.
[[nodiscard]] std::string_view element_symbol(std::string_view text);

/// The symbol of the element with this atomic number, empty outside 1 to 118.
[[nodiscard]] std::string_view element_symbol(int atomic_number);

/// Hydrogen in any isotope: H, D, T.
[[nodiscard]] bool is_hydrogen(std::string_view symbol);

/// HOH, WAT, DOD, TIP3, SOL and the other names of water as a residue.
[[nodiscard]] bool is_water(std::string_view residue);

/// How the name of an atom stands in its file.
enum class NameLayout {
  columns,  ///< four columns of a PDB line, blanks kept: the element ends in the second one
  free,     ///< no columns: the name alone
};

/// The element of an atom by its name, for files that do not say: "CA" in ALA is carbon, "CA  " in
/// CA is calcium, "HH31" hydrogen, "1HB" hydrogen. What begins with no element's symbol gives the
/// first letter as it is, and a name without letters gives "".
[[nodiscard]] std::string_view element_of_atom(std::string_view name, std::string_view residue,
                                               NameLayout layout);

/// The element of a label that begins with its symbol, as those of crystals and XYZ files do:
/// "Si4+", "CL1", "OW2". As above where there is none.
[[nodiscard]] std::string_view element_of_label(std::string_view label);

}  // namespace orthoball
