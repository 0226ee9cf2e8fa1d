// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "orthoball/weights/distinct_sites.h"
#include "orthoball/weights/linear_program.h"

namespace orthoball {

/// The sites at the corners of one simplex, ascending, as DistinctSites numbers them.
using SiteTuple = std::vector<std::uint32_t>;

/// A condition on the power of a site at the witness of a simplex: no less than that of its
/// corners, or that if it is one.
struct WitnessCondition {
  std::size_t simplex;  ///< its number, in order of WitnessProgram::add()
  std::uint32_t site;
  /// With which it enters a sum of conditions, on powers in the sites' unit squared.
  double factor;
};

/// What a WitnessProgram looks for.
struct WitnessOptions {
  double unit = 1.0;     ///< a length about that of the simplices
  double margin = 1e-6;  ///< by which others have more power at a witness, times the squared
                         ///< distance from the nearest corner or, where that is less, the squared
                         ///< diameter; and by which alpha2 is kept, times the largest of alpha2,
                         ///< that and the squared distance of the witness
  std::optional<double> alpha2{};  ///< of which the complex is to hold the simplices; in the unit
                                   ///< of the sites squared. None: any
  /// [site]: the others are taken as hidden; null: all.
  const std::vector<bool>* counted = nullptr;
  /// [site]: its weight may not change; null: all may.
  const std::vector<bool>* is_fixed = nullptr;
  /// [site]: its weight may change at no cost; null: none if there is an alpha2, else all.
  const std::vector<bool>* is_free = nullptr;
};

/// Weights with which simplices are in the alpha complex, changed least in total, as a linear
/// program: each simplex has a witness, a point at which its corners have one power of at most
/// alpha2 and no other site less. In doubles: the result is to be verified.
template <int D>
class WitnessProgram {
 public:
  /// Keeps a reference to the sites.
  WitnessProgram(const DistinctSites<D>& sites, const WitnessOptions& options);

  /// One more simplex that must be there.
  void add(const SiteTuple& simplex);

  /// Infeasible: no weights do, as far as doubles tell.
  [[nodiscard]] Outcome solve();
  /// [site]: the weight less that of the sites, in their unit squared; after solve() was solved.
  [[nodiscard]] std::vector<double> changes() const;
  /// What contradicts each other where no weights do, in doubles: without an alpha2 of which the
  /// complex is to hold them, after solve() was infeasible.
  [[nodiscard]] std::vector<WitnessCondition> contradiction() const;

 private:
  using Vector = std::array<double, std::size_t{D}>;

  // A simplex with its frame: the origin at its first corner, its diameter as the unit.
  struct Witness {
    SiteTuple corners;
    double diameter;
    std::size_t first_variable;         // the coordinates
    std::vector<std::uint32_t> others;  // that have a condition
  };
  // A variable weight: change = plus - minus.
  struct Change {
    std::size_t plus, minus;
    double least_square;  // of the steps to it from corners, in the sites' unit
  };
  // From a corner to a site, in the frame.
  struct Step {
    std::uint32_t from, to;
    Vector along;
    double square;  // |along|^2, but 1 where that is more or it is 0
  };

  [[nodiscard]] Vector in_frame(const Witness& witness, std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] Step step_to(const Witness& witness, std::uint32_t site,
                             std::span<const std::uint32_t> corners) const;
  [[nodiscard]] Change change_of(std::uint32_t site, double square);
  [[nodiscard]] double change(std::uint32_t site) const;
  [[nodiscard]] Vector place(const Witness& witness) const;
  [[nodiscard]] double magnification() const;
  void add_change(std::vector<LinearProgram::Term>& terms, std::uint32_t site, double factor,
                  double square);
  void add_condition(std::size_t number, const Step& step, bool is_corner);
  void add_cut(std::size_t number, const Vector& at);
  [[nodiscard]] double cut_size(const Witness& witness, const Vector& at) const;
  [[nodiscard]] bool add_violated(std::size_t number, const std::vector<double>& changes);

  const DistinctSites<D>& sites_;
  WitnessOptions options_;
  LinearProgram program_;
  std::vector<Witness> witnesses_;
  std::unordered_map<std::uint32_t, Change> changes_;  // looked up only, never walked
  // By their numbers in the program: the simplex and the step, none for a tangent.
  std::vector<std::optional<std::pair<std::size_t, Step>>> conditions_;
  std::optional<std::size_t> lack_;  // variable: what all margins lack, where there is no alpha2
};

extern template class WitnessProgram<2>;  // defined in witness_program.cpp
extern template class WitnessProgram<3>;

}  // namespace orthoball
