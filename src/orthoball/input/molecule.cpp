// SPDX-License-Identifier: MIT
#include "orthoball/input/molecule.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/atom_radii.h"
#include "orthoball/input/elements.h"
#include "orthoball/input/fields.h"

// From the atoms of a file to its sites. Alternates are chosen first, then whole classes of atoms
// are dropped (chains, waters, ligands, hydrogens), then each atom that is left gets its radius.

namespace orthoball {
namespace {

template <class Predicate>
std::size_t drop(std::vector<Atom>& atoms, Predicate is_dropped) {
  return std::erase_if(atoms, is_dropped);
}

// Alternates of one atom share its name and residue. A place in a chain may also be held by
// alternates of different residues (a point mutation seen in part of the crystal): there the
// residue is chosen first, so that no atom of the other one is left beside it.
class Alternates {
 public:
  Alternates(const std::vector<Atom>& atoms, std::string_view wanted) : wanted_(wanted) {
    for (const Atom& atom : atoms) {
      if (atom.alternate.empty()) continue;
      prefer(residues_, place(atom), {rank(atom), atom.residue});
    }
    if (residues_.empty()) return;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      if (!atoms[i].alternate.empty() && holds_place(atoms[i])) {
        atoms_.try_emplace(identity(atoms[i]));
      }
    }
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const auto found = atoms_.find(identity(atoms[i]));
      if (found == atoms_.end() || !holds_place(atoms[i])) continue;
      std::optional<std::pair<Rank, std::size_t>>& best = found->second;
      if (!best || best->first < rank(atoms[i])) best = {rank(atoms[i]), i};
    }
  }

  [[nodiscard]] bool is_empty() const { return residues_.empty(); }

  // Is atom i, with these properties, the one of its alternates to keep?
  [[nodiscard]] bool keeps(const Atom& atom, std::size_t i) const {
    if (!holds_place(atom)) return false;
    const auto found = atoms_.find(identity(atom));
    return found == atoms_.end() || found->second->second == i;
  }

 private:
  using Rank = std::pair<bool, double>;  // the wanted letter, then occupancy; the first on ties
  using Place = std::tuple<std::string_view, std::string_view, std::string_view, bool>;
  using Identity = std::tuple<std::string_view, std::string_view, std::string_view,
                              std::string_view, std::string_view>;
  using Choice = std::pair<Rank, std::string_view>;

  [[nodiscard]] Rank rank(const Atom& atom) const {
    return {!wanted_.empty() && atom.alternate == wanted_, atom.occupancy};
  }
  static Place place(const Atom& atom) {
    return {atom.chain, atom.residue_number, atom.insertion, is_water(atom.residue)};
  }
  static Identity identity(const Atom& atom) {
    return {atom.chain, atom.residue_number, atom.insertion, atom.residue, atom.name};
  }
  static void prefer(std::map<Place, Choice>& choices, const Place& key, const Choice& choice) {
    const auto [found, is_new] = choices.try_emplace(key, choice);
    if (!is_new && found->second.first < choice.first) found->second = choice;
  }
  [[nodiscard]] bool holds_place(const Atom& atom) const {
    if (atom.alternate.empty()) return true;
    const auto found = residues_.find(place(atom));
    return found == residues_.end() || found->second.second == atom.residue;
  }

  std::string_view wanted_;
  std::map<Place, Choice> residues_;  // of the atoms with alternates
  std::map<Identity, std::optional<std::pair<Rank, std::size_t>>> atoms_;
};

void choose_alternates(Molecule& molecule, const MoleculeOptions& options) {
  const std::string_view wanted = options.altloc;
  const bool has_wanted =
      wanted.empty() || std::any_of(molecule.atoms.begin(), molecule.atoms.end(),
                                    [&](const Atom& atom) { return atom.alternate == wanted; });
  if (!has_wanted) {
    molecule.warnings.push_back("no atom is an alternate " + quoted(wanted));
  }
  const Alternates alternates(molecule.atoms, wanted);
  if (alternates.is_empty()) return;
  std::size_t row = 0;
  const std::size_t dropped =
      drop(molecule.atoms, [&](const Atom& atom) { return !alternates.keeps(atom, row++); });
  if (dropped == 0) return;
  const std::string rule = wanted.empty() ? "the highest occupancy, the first on ties"
                                          : quoted(wanted) + ", else the highest occupancy";
  molecule.notes.push_back("alternates: " + rule + "; " + counted(dropped, "atom") + " left out" +
                           (wanted.empty() ? " (--altloc X prefers X)" : ""));
}

void choose_chains(const Source& source, Molecule& molecule,
                   const std::vector<std::string>& wanted) {
  if (wanted.empty()) return;
  std::set<std::string_view> chains;
  if (molecule.has_residues) {
    for (const Atom& atom : molecule.atoms) chains.insert(atom.chain);
  }
  for (const std::string& chain : wanted) {
    if (chains.count(chain) != 0) continue;
    std::string there;
    for (const std::string_view each : chains) {
      if (!each.empty()) there += (there.empty() ? "" : ", ") + std::string(each);
      if (there.size() > 200) break;
    }
    throw ParseError(
        source.name, 0,
        "no atom is in chain " + quoted(chain) +
            (there.empty() ? "; the file names no chains" : "; the chains are " + there));
  }
  const std::size_t dropped = drop(molecule.atoms, [&](const Atom& atom) {
    return std::find(wanted.begin(), wanted.end(), atom.chain) == wanted.end();
  });
  if (dropped != 0) {
    molecule.notes.push_back("chains: " + counted(dropped, "atom") + " of others left out");
  }
}

void drop_classes(Molecule& molecule, const MoleculeOptions& options) {
  const auto apply = [&](bool is_kept, const char* what, const char* option, auto belongs) {
    if (is_kept) return;
    const std::size_t dropped = drop(molecule.atoms, belongs);
    if (dropped == 0) return;
    molecule.notes.push_back(std::string(what) + " dropped: " + counted(dropped, "atom") + " (--" +
                             option + " keep keeps them)");
  };
  apply(options.waters, "waters", "waters",
        [](const Atom& atom) { return is_water(atom.residue); });
  apply(options.ligands, "ligands", "ligands",
        [](const Atom& atom) { return atom.is_hetero && !is_water(atom.residue); });
  apply(options.hydrogens, "hydrogens", "hydrogens",
        [](const Atom& atom) { return is_hydrogen(atom.element); });
}

std::string description_of(const Atom& atom) {
  std::string text = "atom";
  if (!atom.name.empty()) text += ' ' + quoted(atom.name);
  if (!atom.residue.empty()) text += " of residue " + quoted(atom.residue);
  if (!atom.residue_number.empty()) {
    text += ' ' + std::string(atom.residue_number) + std::string(atom.insertion);
  }
  if (!atom.chain.empty()) text += " in chain " + std::string(atom.chain);
  return text;
}

// Gives every atom its radius and says in words where they come from.
std::string assign_radii(const Source& source, Molecule& molecule, const ReadOptions& options) {
  if (options.radii.empty() && molecule.has_radii) {
    const auto negative = std::count_if(molecule.atoms.begin(), molecule.atoms.end(),
                                        [](const Atom& atom) { return atom.radius.nearest < 0; });
    if (negative != 0) {
      molecule.warnings.push_back(
          counted(static_cast<std::size_t>(negative), "atom") +
          " with a negative radius -r, taken as an imaginary ball of weight -r^2");
    }
    return "the file's own";
  }
  RadiusAssignment assignment(options);
  for (Atom& atom : molecule.atoms) assignment.assign(source, atom);
  assignment.warn(molecule.warnings);
  if (options.radii == "protor") {
    const auto hydrogens =
        std::count_if(molecule.atoms.begin(), molecule.atoms.end(),
                      [](const Atom& atom) { return is_hydrogen(atom.element); });
    if (hydrogens != 0) {
      molecule.warnings.push_back("protor radii contain the hydrogens, and " +
                                  counted(static_cast<std::size_t>(hydrogens), "hydrogen") +
                                  " of the file have balls of their own (--hydrogens drop)");
    }
  }
  return assignment.description();
}

SiteLabels labels_of(const Molecule& molecule) {
  SiteLabels labels;
  const std::size_t count = molecule.atoms.size();
  labels.line.reserve(count);
  labels.element.reserve(count);
  for (const Atom& atom : molecule.atoms) {
    labels.line.push_back(static_cast<std::uint32_t>(
        std::min<std::size_t>(atom.line, std::numeric_limits<std::uint32_t>::max())));
    labels.element.emplace_back(atom.element);
  }
  if (std::any_of(molecule.atoms.begin(), molecule.atoms.end(),
                  [](const Atom& atom) { return !atom.name.empty(); })) {
    labels.atom.reserve(count);
    for (const Atom& atom : molecule.atoms) labels.atom.emplace_back(atom.name);
  }
  if (!molecule.has_residues) return labels;
  labels.residue.reserve(count);
  labels.residue_id.reserve(count);
  labels.chain.reserve(count);
  for (const Atom& atom : molecule.atoms) {
    labels.residue.emplace_back(atom.residue);
    labels.residue_id.emplace_back(atom.residue_number).append(atom.insertion);
    labels.chain.emplace_back(atom.chain);
  }
  return labels;
}

}  // namespace

RadiusAssignment::RadiusAssignment(const ReadOptions& options)
    : radii_(options.radii.empty() ? "bondi" : options.radii, options.limited) {
  if (!options.default_radius) return;
  const DecimalParse parse = parse_decimal(*options.default_radius);
  if (parse.fault != DecimalFault::none) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "the default radius is " + quoted(*options.default_radius) +
                         "; it must be a finite number");
  }
  default_radius_ = parse.number;
  default_text_ = *options.default_radius;
}

std::optional<DecimalNumber> RadiusAssignment::radius(const Atom& atom) {
  const auto found = radii_.radius(atom.element, atom.residue, atom.name);
  if (!found) return std::nullopt;
  elements_[found->source].insert(atom.element);
  return found->radius;
}

void RadiusAssignment::assign(const Source& source, Atom& atom) {
  if (const auto found = radius(atom)) {
    atom.radius = *found;
    return;
  }
  const std::string who =
      description_of(atom) +
      (atom.element.empty() ? " has no element" : " has element " + quoted(atom.element));
  if (!default_radius_) {
    throw ParseError(source.name, atom.line,
                     who + ", which has no radius in " + radii_.name() +
                         "; give one with --default-radius or a radius file, or take "
                         "--radii none");
  }
  atom.radius = *default_radius_;
  if (++defaulted_ <= kListed) {
    listed_ += (listed_.empty() ? "line " : "; line ") + std::to_string(atom.line) + ": " + who;
  }
}

std::string RadiusAssignment::description() const {
  std::string text = radii_.name() + " (" + radii_.main_source();
  for (const auto& [source, elements] : elements_) {
    if (radii_.main_source().substr(0, source.size()) == source || source == radii_.name()) {
      continue;
    }
    text += "; " + source + " for ";
    const char* separator = "";
    for (const std::string_view element : elements) {
      text += separator + std::string(element);
      separator = ", ";
    }
  }
  if (defaulted_ != 0) text += "; " + default_text_ + " for " + counted(defaulted_, "atom");
  return text + ')';
}

void RadiusAssignment::warn(std::vector<std::string>& warnings) const {
  if (defaulted_ == 0) return;
  warnings.push_back("default radius " + default_text_ + " for " + counted(defaulted_, "atom") +
                     ": " + listed_ + (defaulted_ > kListed ? "; ..." : ""));
}

bool ModelChoice::takes(int number) {
  if (last_ != number) {
    last_ = number;
    seen_.insert(number);
    if (!taken_ && (!wanted_ || *wanted_ == number)) taken_ = number;
  }
  return taken_ == number;
}

std::string ModelChoice::all() const {
  constexpr std::size_t kMost = 8;  // named one by one
  const int first = *seen_.begin(), last = *seen_.rbegin();
  std::string text = std::string(noun_) + (seen_.size() == 1 ? " " : "s ");
  if (seen_.size() > 2 &&
      static_cast<std::size_t>(last) - static_cast<std::size_t>(first) + 1 == seen_.size()) {
    return text + std::to_string(first) + " to " + std::to_string(last);
  }
  std::size_t named = 0;
  for (const int number : seen_) {
    if (named == kMost) return text + ", ... " + std::to_string(last);
    text += (named++ == 0 ? "" : ", ") + std::to_string(number);
  }
  return text;
}

void ModelChoice::finish(const Source& source, std::vector<std::string>& notes) const {
  const std::string noun = noun_;
  if (wanted_ && !taken_ && !seen_.empty()) {
    throw ParseError(source.name, 0,
                     "no " + noun + ' ' + std::to_string(*wanted_) + "; the file has " + all());
  }
  if (!taken_ || seen_.size() == 1) return;
  const bool is_counted = *seen_.begin() == 1 && std::cmp_equal(*seen_.rbegin(), seen_.size());
  notes.push_back(noun + ' ' + std::to_string(*taken_) +
                  (is_counted ? " of " + std::to_string(seen_.size()) : " of the " + all()) +
                  (wanted_ ? "" : " (--model N takes another)"));
}

void require_molecule_options(const ReadOptions& options, std::string_view format) {
  const auto refuse = [&](const char* what) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     std::string(what) + " does not fit the format " + std::string(format) +
                         ", which holds the atoms of a molecule in space");
  };
  if (options.dimension.value_or(3) != 3) refuse("dimension 2");
  if (!options.columns.empty()) refuse("a choice of columns");
  if (!options.radius_column.empty()) refuse("a radius column");
  if (!options.weight_column.empty()) refuse("a weight column");
}

Reading reading_of(const Source& source, Molecule molecule, const ReadOptions& options) {
  choose_alternates(molecule, options.molecule);
  choose_chains(source, molecule, options.molecule.chains);
  drop_classes(molecule, options.molecule);

  const bool is_weighted = options.radii != "none";
  std::string radii = is_weighted ? assign_radii(source, molecule, options) : "none";
  DecimalRows rows(3, is_weighted ? WeightKind::radius : WeightKind::none);
  rows.reserve(molecule.atoms.size());
  for (const Atom& atom : molecule.atoms) rows.add(atom.position, atom.radius);

  Reading reading{.points = std::move(rows).points(),
                  .labels = labels_of(molecule),
                  .file = source.name,
                  .format = {},
                  .radii = std::move(radii),
                  .is_molecule = is_weighted,
                  .notes = std::move(molecule.notes),
                  .warnings = std::move(molecule.warnings)};
  return reading;
}

}  // namespace orthoball
