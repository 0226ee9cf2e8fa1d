// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/input/atom_radii.h"
#include "orthoball/input/decimal.h"
#include "orthoball/input/read.h"
#include "orthoball/input/source.h"

namespace orthoball {

/// One atom record of a molecule file. Texts are views into the file's bytes.
struct Atom {
  std::array<DecimalNumber, 3> position;  ///< Angstrom
  DecimalNumber radius;                   ///< Angstrom, only where Molecule::has_radii
  double occupancy = 1.0;                 ///< 1 where the file has no finite number
  std::string_view element;               ///< a symbol, or what stands where one should
  std::string_view name;                  ///< blanks removed, as all that follow
  std::string_view residue;
  std::string_view residue_number;
  std::string_view insertion;  ///< insertion code
  std::string_view chain;
  std::string_view alternate;  ///< letter of the alternate location, empty for none
  bool is_hetero = false;      ///< HETATM
  std::size_t line = 0;        ///< 1-based
};

/// The atoms of the model that is taken, all alternates, waters and so on among them.
struct Molecule {
  std::vector<Atom> atoms;         ///< in the order of the file
  bool has_radii = false;          ///< the file gives radii of its own
  bool has_residues = false;       ///< atoms have names and belong to residues, perhaps of chains
  std::vector<std::string> notes;  ///< as in Reading
  std::vector<std::string> warnings;  ///< as in Reading
};

/// Which of the models (or frames) of a file is taken: the one asked for, else the first.
class ModelChoice {
 public:
  /// @param noun  "model" or "frame", for notes and messages.
  ModelChoice(std::optional<int> wanted, const char* noun) : wanted_(wanted), noun_(noun) {}

  /// An atom of model `number` follows: is it one to take?
  [[nodiscard]] bool takes(int number);
  /// The smallest number above those of all models so far.
  [[nodiscard]] int next_number() const { return seen_.empty() ? 1 : *seen_.rbegin() + 1; }
  [[nodiscard]] bool has_seen(int number) const { return seen_.count(number) != 0; }
  /// Notes the choice if there was one.
  /// @throws ParseError if the model asked for is not there.
  void finish(const Source& source, std::vector<std::string>& notes) const;

 private:
  /// "models 1 to 20", "models 2, 5".
  [[nodiscard]] std::string all() const;

  std::optional<int> wanted_;
  const char* noun_;
  std::optional<int> last_;  // what takes() was asked last
  std::optional<int> taken_;
  std::set<int> seen_;
};

/// Gives atoms their radii, and says in words where they come from.
class RadiusAssignment {
 public:
  /// The texts of atoms must live as long as this does.
  /// @throws ParseError for a radius file that cannot be read.
  /// @throws InputError for a default radius that is not a number.
  explicit RadiusAssignment(const ReadOptions& options);

  /// The radius that the set has for an atom like this; empty where it has none.
  [[nodiscard]] std::optional<DecimalNumber> radius(const Atom& atom);
  /// Gives the atom that radius, else the default one.
  /// @throws ParseError at the atom's line where there is none.
  void assign(const Source& source, Atom& atom);

  /// As in Reading::radii: "bondi (Bondi 1964, H 1.20; Alvarez 2013 for Ca, Fe)".
  [[nodiscard]] std::string description() const;
  /// Names the atoms with the default radius, if there are any.
  void warn(std::vector<std::string>& warnings) const;

 private:
  static constexpr std::size_t kListed = 5;

  AtomRadii radii_;
  std::optional<DecimalNumber> default_radius_;
  std::string default_text_;
  std::map<std::string, std::set<std::string_view>> elements_;  // by source of their radius
  std::size_t defaulted_ = 0;
  std::string listed_;  // the first kListed of them
};

/// Refuses options that are meant for tables or for the plane.
/// @throws InputError
void require_molecule_options(const ReadOptions& options, std::string_view format);

/// Chooses among alternates, drops what `options` drops, gives radii and labels. Every choice that
/// changed something becomes a note.
/// @throws ParseError for an atom without a radius, a chain that is not there.
/// @throws InputError for a default radius that is not a number.
[[nodiscard]] Reading reading_of(const Source& source, Molecule molecule,
                                 const ReadOptions& options);

}  // namespace orthoball
