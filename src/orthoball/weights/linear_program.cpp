// SPDX-License-Identifier: MIT
#include "orthoball/weights/linear_program.h"

#include "orthoball/error.h"

#ifdef ORTHOBALL_CLP

#include <Clp_C_Interface.h>
#include <dlfcn.h>

namespace orthoball {
namespace {

constexpr double kTolerance = 1e-9;
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
    const std::size_t variables_more = costs.size() - variables_handed;
    const std::vector<CoinBigIndex> no_terms(variables_more + 1);
    const std::vector<double> no_limit(variables_more, kInfinity);
    const int no_row = 0;
    const double no_number = 0.0;
    solver().add_columns(clp, static_cast<int>(variables_more), &least_values[variables_handed],
                         no_limit.data(), &costs[variables_handed], no_terms.data(), &no_row,
                         &no_number);
    const std::size_t first = conditions_handed;
    std::vector<CoinBigIndex> begins(starts.begin() + static_cast<std::ptrdiff_t>(first),
                                     starts.end());
    for (CoinBigIndex& begin : begins) begin -= starts[first];
    const auto term = static_cast<std::size_t>(starts[first]);
    solver().add_rows(clp, static_cast<int>(least_sums.size() - first), &least_sums[first],
                      &most_sums[first], begins.data(), &variables[term], &coefficients[term]);
    variables_handed = costs.size();
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

  Clp_Simplex* clp = nullptr;
  std::vector<double> least_values, costs;    // [variable]
  std::vector<double> least_sums, most_sums;  // [condition]
  std::vector<CoinBigIndex> starts{0};        // [condition]: its first term, and the end
  std::vector<int> variables;                 // [term]
  std::vector<double> coefficients;           // [term]
  std::size_t variables_handed = 0, conditions_handed = 0;

 private:
  void begin() {
    clp = solver().new_model();
    variables_handed = conditions_handed = 0;
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
  model_->least_values.push_back(least);
  model_->costs.push_back(cost);
  return model_->costs.size() - 1;
}

std::size_t LinearProgram::add_condition(double least, double most, std::span<const Term> terms) {
  for (const Term& term : terms) {
    model_->variables.push_back(static_cast<int>(term.variable));
    model_->coefficients.push_back(term.coefficient);
  }
  model_->starts.push_back(static_cast<CoinBigIndex>(model_->variables.size()));
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
  return solver().primal_column_solution(model_->clp)[variable];
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
