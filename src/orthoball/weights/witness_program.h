// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "orthoball/weights/distinct_sites.h"
#include "orthoball/weights/linear_program.h"

namespace orthoball {

/// The sites at the corners of one simplex, ascending, as DistinctSites numbers them.
using SiteTuple = std::vector<std::uint32_t>;

/// What a WitnessProgram looks for.
struct WitnessOptions {
  double unit = 1.0;    ///< a length about that of the simplices
  double margin = 0.0;  ///< by which others have more power at a witness, and alpha2 is kept: times
                        ///< the diameter of the simplex squared
  std::optional<double> alpha2{};  ///< of which the complex is to hold the simplices; in the unit
                                   ///< of the sites squared. None: any
  const std::vector<bool>* counted =
      nullptr;  ///< [site]: the others are taken as hidden; null: all
  const std::vector<bool>* is_fixed =
      nullptr;                                 ///< [site]: its weight may not change; null: all may
  const std::vector<bool>* is_free = nullptr;  ///< [site]: its weight may change at no cost; null:
                                               ///< none if there is an alpha2, else all
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

  /// @return false where no weights do.
  /// @throws LimitError where the solver gives up.
  [[nodiscard]] bool solve();
  /// [site]: the weight less that of the sites, in their unit squared; after solve() was true.
  [[nodiscard]] std::vector<double> changes() const;
  /// Numbers, in order of add(), of simplices that no weights hold together; after solve() was
  /// false. Not the fewest.
  [[nodiscard]] std::vector<std::size_t> contradiction() const;

 private:
  using Vector = std::array<double, std::size_t{D}>;

  // A simplex with its frame: the origin at its first corner, its diameter as the unit.
  struct Witness {
    SiteTuple corners;
    Vector origin;
    double diameter;
    std::size_t first_variable;         // the coordinates, then |x|^2 - power
    std::vector<std::uint32_t> others;  // that have a condition
  };
  // A variable weight: change = plus - minus.
  struct Change {
    std::size_t plus, minus;
  };

  [[nodiscard]] Vector in_frame(const Witness& witness, std::uint32_t site) const;
  [[nodiscard]] Change change_of(std::uint32_t site);
  [[nodiscard]] double change(std::uint32_t site) const;
  [[nodiscard]] Vector place(const Witness& witness) const;
  void add_condition(std::size_t number, std::uint32_t site, bool is_corner);
  void add_cut(std::size_t number, const Vector& at);
  [[nodiscard]] bool add_violated(std::size_t number, const std::vector<double>& changes);

  const DistinctSites<D>& sites_;
  WitnessOptions options_;
  LinearProgram program_;
  std::vector<Witness> witnesses_;
  std::unordered_map<std::uint32_t, Change> changes_;  // looked up only, never walked
  std::vector<std::size_t> witness_of_condition_;
};

extern template class WitnessProgram<2>;  // defined in witness_program.cpp
extern template class WitnessProgram<3>;

}  // namespace orthoball
