// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace orthoball {

/// Whether this library was built with a solver of linear programs.
[[nodiscard]] bool has_linear_solver();

/// A linear program that grows: the least cost of real variables under linear conditions. Numbers
/// are doubles and conditions hold to about 1e-9: what is decided by it is to be verified.
///
/// The same calls give the same solution. Behind it stands COIN-OR CLP, in linear_program.cpp
/// alone.
class LinearProgram {
 public:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// coefficient * variable, in a condition.
  struct Term {
    std::size_t variable;
    double coefficient;
  };

  /// @throws LimitError where has_linear_solver() is false.
  LinearProgram();
  LinearProgram(LinearProgram&&) noexcept;
  LinearProgram& operator=(LinearProgram&&) noexcept;
  ~LinearProgram();

  /// A new variable from `least`, with its cost for each unit; its number, from 0.
  [[nodiscard]] std::size_t add_variable(double least, double cost);
  /// A condition: least <= sum of terms <= most; its number, from 0.
  std::size_t add_condition(double least, double most, std::span<const Term> terms);

  /// Solves, beginning from the last solution.
  /// @return false where no values satisfy the conditions.
  /// @throws LimitError where the solver gives up.
  [[nodiscard]] bool solve();
  /// Of a variable in the last solution; after solve() was true.
  [[nodiscard]] double value(std::size_t variable) const;
  /// [k]: conditions that no values satisfy together; after solve() was false. All if the solver
  /// names none.
  [[nodiscard]] std::vector<std::size_t> contradiction() const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace orthoball
