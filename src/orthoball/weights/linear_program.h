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

/// What became of a linear program.
enum class Outcome {
  solved,
  infeasible,  ///< no values satisfy the conditions
  unknown,     ///< rounding, or the length of the way, stopped the solver
};

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
  [[nodiscard]] Outcome solve();
  /// Of a variable in the last solution; after solve() was solved.
  [[nodiscard]] double value(std::size_t variable) const;
  /// By how much the least cost grows for each unit that is added to what a condition demands: 0
  /// where that does not matter; after solve() was solved. Times these factors the conditions sum
  /// up to one that no values of less cost satisfy.
  [[nodiscard]] double price(std::size_t condition) const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace orthoball
