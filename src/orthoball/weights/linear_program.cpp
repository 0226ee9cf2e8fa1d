// SPDX-License-Identifier: MIT
#include "orthoball/weights/linear_program.h"

#include "orthoball/error.h"

#ifdef ORTHOBALL_CLP

#include <Clp_C_Interface.h>
#include <dlfcn.h>

#include <algorithm>
#include <cmath>

namespace orthoball {
namespace {

constexpr double kTolerance = 1e-9;
constexpr double kKept = 1e-8;                // so far off is kept
constexpr double kRounded = 1e-15;            // or this of the largest term
constexpr int kUnscaled = 0, kScaled = 3;     // modes of Clp_scaling
constexpr int kOptimal = 0, kInfeasible = 1;  // what Clp_status says

// CLP, loaded when it is first needed: it brings OpenBLAS along, which takes memory and starts
// threads in every program that is linked with it.
struct Functions {
  bool lacks_one = false;
  void* library = dlopen(ORTHOBALL_CLP, RTLD_NOW | RTLD_LOCAL);
  decltype(&Clp_newModel) new_model = find<decltype(&Clp_newModel)>("Clp_newModel");
  decltype(&Clp_deleteModel) delete_model = find<decltype(&Clp_deleteModel)>("Clp_deleteModel");
  decltype(&Clp_setLogLevel) set_log_level = find<decltype(&Clp_setLogLevel)>("Clp_setLogLevel");
  decltype(&Clp_setMaximumIterations) set_maximum_iterations =
      find<decltype(&Clp_setMaximumIterations)>("Clp_setMaximumIterations");
  decltype(&Clp_setPrimalTolerance) set_primal_tolerance =
      find<decltype(&Clp_setPrimalTolerance)>("Clp_setPrimalTolerance");
  decltype(&Clp_setDualTolerance) set_dual_tolerance =
      find<decltype(&Clp_setDualTolerance)>("Clp_setDualTolerance");
  decltype(&Clp_scaling) scaling = find<decltype(&Clp_scaling)>("Clp_scaling");
  decltype(&Clp_addColumns) add_columns = find<decltype(&Clp_addColumns)>("Clp_addColumns");
  decltype(&Clp_addRows) add_rows = find<decltype(&Clp_addRows)>("Clp_addRows");
  decltype(&Clp_dual) dual = find<decltype(&Clp_dual)>("Clp_dual");
  decltype(&Clp_primal) primal = find<decltype(&Clp_primal)>("Clp_primal");
  decltype(&Clp_status) status = find<decltype(&Clp_status)>("Clp_status");
  decltype(&Clp_primalColumnSolution) primal_column_solution =
      find<decltype(&Clp_primalColumnSolution)>("Clp_primalColumnSolution");
  decltype(&Clp_dualRowSolution) dual_row_solution =
      find<decltype(&Clp_dualRowSolution)>("Clp_dualRowSolution");

  [[nodiscard]] bool are_there() const { return library != nullptr && !lacks_one; }

 private:
  template <class Function>
  [[nodiscard]] Function find(const char* name) {
    auto* const function =
        library == nullptr ? nullptr : reinterpret_cast<Function>(dlsym(library, name));
    lacks_one |= function == nullptr;
    return function;
  }
};

const Functions& solver() {
  static const Functions functions;
  return functions;
}

}  // namespace

struct LinearProgram::Model {
  Model() { begin(); }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  ~Model() { solver().delete_model(clp); }

  // Hands over what was added since the last time.
  void hand_over() {
    const std::size_t columns_more = costs.size() - columns_handed;
    const std::vector<CoinBigIndex> no_terms(columns_more + 1);
    const std::vector<double> no_limit(columns_more, kInfinity);
    const int no_row = 0;
    const double no_number = 0.0;
    solver().add_columns(clp, static_cast<int>(columns_more), &least_values[columns_handed],
                         no_limit.data(), &costs[columns_handed], no_terms.data(), &no_row,
                         &no_number);
    const std::size_t first = conditions_handed;
    std::vector<CoinBigIndex> begins(starts.begin() + static_cast<std::ptrdiff_t>(first),
                                     starts.end());
    for (CoinBigIndex& begin : begins) begin -= starts[first];
    const auto term = static_cast<std::size_t>(starts[first]);
    solver().add_rows(clp, static_cast<int>(least_sums.size() - first), &least_sums[first],
                      &most_sums[first], begins.data(), &columns[term], &coefficients[term]);
    columns_handed = costs.size();
    conditions_handed = least_sums.size();
    // More than any program needs that does not go round in circles.
    solver().set_maximum_iterations(
        clp, static_cast<int>(50 * (costs.size() + least_sums.size()) + 10'000));
  }
  // Forgets the last solution, which may be where rounding has led astray.
  void begin_anew() {
    solver().delete_model(clp);
    begin();
    hand_over();
  }

  // Whether the last solution keeps the conditions as they were given: CLP looks at them scaled.
  [[nodiscard]] bool is_kept() const {
    const double* const values = solver().primal_column_solution(clp);
    for (std::size_t condition = 0; condition < least_sums.size(); ++condition) {
      double sum = 0.0, off_by = kKept;
      for (auto term = static_cast<std::size_t>(starts[condition]);
           term < static_cast<std::size_t>(starts[condition + 1]); ++term) {
        const double part = coefficients[term] * values[columns[term]];
        sum += part;
        off_by = std::max(off_by, kRounded * std::abs(part));
      }
      const double off = std::max(least_sums[condition] - sum, sum - most_sums[condition]);
      if (off > off_by) return false;
    }
    return true;
  }

  Clp_Simplex* clp = nullptr;
  // [variable]: its column; a variable without a least value is that less the next one, for CLP
  // ends the program over columns that are free.
  std::vector<std::size_t> column_of;
  std::vector<bool> is_difference;            // [variable]
  std::vector<double> least_values, costs;    // [column]
  std::vector<double> least_sums, most_sums;  // [condition]
  std::vector<CoinBigIndex> starts{0};        // [condition]: its first term, and the end
  std::vector<int> columns;                   // [term]
  std::vector<double> coefficients;           // [term]
  std::size_t columns_handed = 0, conditions_handed = 0;

 private:
  void begin() {
    clp = solver().new_model();
    columns_handed = conditions_handed = 0;
    solver().set_log_level(clp, 0);
    solver().set_primal_tolerance(clp, kTolerance);
    solver().set_dual_tolerance(clp, kTolerance);
  }
};

bool has_linear_solver() { return solver().are_there(); }

LinearProgram::LinearProgram() {
  if (!has_linear_solver()) {
    throw LimitError(
        "the solver of linear programs, COIN-OR CLP (" ORTHOBALL_CLP
        "), cannot be loaded; weights that enforce simplices need it: install it, on Debian "
        "and Ubuntu as the package coinor-libclp1");
  }
  model_ = std::make_unique<Model>();
}

std::size_t LinearProgram::add_variable(double least, double cost) {
  const bool is_difference = least == -kInfinity;
  model_->column_of.push_back(model_->costs.size());
  model_->is_difference.push_back(is_difference);
  model_->least_values.push_back(is_difference ? 0.0 : least);
  model_->costs.push_back(cost);
  if (is_difference) {
    model_->least_values.push_back(0.0);
    model_->costs.push_back(-cost);
  }
  return model_->column_of.size() - 1;
}

std::size_t LinearProgram::add_condition(double least, double most, std::span<const Term> terms) {
  for (const Term& term : terms) {
    const std::size_t column = model_->column_of[term.variable];
    model_->columns.push_back(static_cast<int>(column));
    model_->coefficients.push_back(term.coefficient);
    if (!model_->is_difference[term.variable]) continue;
    model_->columns.push_back(static_cast<int>(column + 1));
    model_->coefficients.push_back(-term.coefficient);
  }
  model_->starts.push_back(static_cast<CoinBigIndex>(model_->columns.size()));
  model_->least_sums.push_back(least);
  model_->most_sums.push_back(most);
  return model_->least_sums.size() - 1;
}

Outcome LinearProgram::solve() {
  const auto status_of = [&](const auto& method) {
    method(model_->clp, 0);
    return solver().status(model_->clp);
  };
  model_->hand_over();
  const int status = status_of(solver().dual);
  // What is best as CLP scales it can break the conditions as they are.
  if (status == kOptimal && !model_->is_kept()) {
    solver().scaling(model_->clp, kUnscaled);
    (void)status_of(solver().primal);
    solver().scaling(model_->clp, kScaled);
  }
  if (status == kOptimal) return Outcome::solved;
  // Once more by the other method and from the beginning, for what rounding may have done.
  model_->begin_anew();
  const int again = status_of(solver().primal);
  if (again == kOptimal) return Outcome::solved;
  if (again == kInfeasible) return Outcome::infeasible;
  if (status != kInfeasible) return Outcome::unknown;
  model_->begin_anew();
  return status_of(solver().dual) == kInfeasible ? Outcome::infeasible : Outcome::unknown;
}

double LinearProgram::value(std::size_t variable) const {
  const double* const value =
      solver().primal_column_solution(model_->clp) + model_->column_of[variable];
  return model_->is_difference[variable] ? value[0] - value[1] : value[0];
}

double LinearProgram::price(std::size_t condition) const {
  return solver().dual_row_solution(model_->clp)[condition];
}

#else

namespace orthoball {

struct LinearProgram::Model {};

bool has_linear_solver() { return false; }

LinearProgram::LinearProgram() {
  throw LimitError(
      "this library was built without the solver of linear programs that weights which enforce "
      "simplices need; build it with COIN-OR CLP (./bootstrap build, ORTHOBALL_CLP=ON)");
}
std::size_t LinearProgram::add_variable(double, double) { return 0; }
std::size_t LinearProgram::add_condition(double, double, std::span<const Term>) { return 0; }
Outcome LinearProgram::solve() { return Outcome::unknown; }
double LinearProgram::value(std::size_t) const { return 0.0; }
double LinearProgram::price(std::size_t) const { return 0.0; }

#endif

LinearProgram::LinearProgram(LinearProgram&&) noexcept = default;
LinearProgram& LinearProgram::operator=(LinearProgram&&) noexcept = default;
LinearProgram::~LinearProgram() = default;

}  // namespace orthoball
