// SPDX-License-Identifier: MIT
#include "orthoball/weights/linear_program.h"

#include "orthoball/error.h"

#ifdef ORTHOBALL_CLP

#include <Clp_C_Interface.h>
#include <dlfcn.h>

#include <cmath>

namespace orthoball {
namespace {

constexpr double kTolerance = 1e-9;
constexpr int kOptimal = 0, kInfeasible = 1;  // what Clp_status says

// CLP, loaded when it is first needed: it brings OpenBLAS along, which takes memory and starts
// threads in every program that is linked with it.
struct Functions {
  void* library = dlopen(ORTHOBALL_CLP, RTLD_NOW | RTLD_LOCAL);
  decltype(&Clp_newModel) new_model = find<decltype(&Clp_newModel)>("Clp_newModel");
  decltype(&Clp_deleteModel) delete_model = find<decltype(&Clp_deleteModel)>("Clp_deleteModel");
  decltype(&Clp_setLogLevel) set_log_level = find<decltype(&Clp_setLogLevel)>("Clp_setLogLevel");
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
  decltype(&Clp_numberRows) number_rows = find<decltype(&Clp_numberRows)>("Clp_numberRows");
  decltype(&Clp_infeasibilityRay) infeasibility_ray =
      find<decltype(&Clp_infeasibilityRay)>("Clp_infeasibilityRay");
  decltype(&Clp_freeRay) free_ray = find<decltype(&Clp_freeRay)>("Clp_freeRay");

 private:
  template <class Function>
  [[nodiscard]] Function find(const char* name) const {
    return library == nullptr ? nullptr : reinterpret_cast<Function>(dlsym(library, name));
  }
};

const Functions& solver() {
  static const Functions functions;
  return functions;
}

}  // namespace

struct LinearProgram::Model {
  Model() : clp(solver().new_model()) {
    solver().set_log_level(clp, 0);
    solver().set_primal_tolerance(clp, kTolerance);
    solver().set_dual_tolerance(clp, kTolerance);
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  ~Model() { solver().delete_model(clp); }

  // Hands over what was added since the last time.
  void hand_over() {
    const std::vector<CoinBigIndex> no_terms(costs.size() + 1);
    const std::vector<double> no_limit(costs.size(), kInfinity);
    const int no_row = 0;
    const double no_number = 0.0;
    solver().add_columns(clp, static_cast<int>(costs.size()), least_values.data(), no_limit.data(),
                         costs.data(), no_terms.data(), &no_row, &no_number);
    solver().add_rows(clp, static_cast<int>(least_sums.size()), least_sums.data(), most_sums.data(),
                      starts.data(), variables.data(), coefficients.data());
    for (auto* const numbers : {&least_values, &costs, &least_sums, &most_sums, &coefficients}) {
      numbers->clear();
    }
    variables.clear();
    starts.resize(1);
  }

  Clp_Simplex* clp;
  std::size_t variable_count = 0, condition_count = 0;
  // Not yet handed over: variables, then conditions with their terms.
  std::vector<double> least_values, costs, least_sums, most_sums, coefficients;
  std::vector<int> variables;
  std::vector<CoinBigIndex> starts{0};
};

bool has_linear_solver() { return solver().library != nullptr; }

LinearProgram::LinearProgram() {
  if (!has_linear_solver()) {
    throw LimitError("the solver of linear programs, COIN-OR CLP (" ORTHOBALL_CLP
                     "), cannot be loaded; weights that enforce simplices need it");
  }
  model_ = std::make_unique<Model>();
}

std::size_t LinearProgram::add_variable(double least, double cost) {
  model_->least_values.push_back(least);
  model_->costs.push_back(cost);
  return model_->variable_count++;
}

std::size_t LinearProgram::add_condition(double least, double most, std::span<const Term> terms) {
  for (const Term& term : terms) {
    model_->variables.push_back(static_cast<int>(term.variable));
    model_->coefficients.push_back(term.coefficient);
  }
  model_->starts.push_back(static_cast<CoinBigIndex>(model_->variables.size()));
  model_->least_sums.push_back(least);
  model_->most_sums.push_back(most);
  return model_->condition_count++;
}

bool LinearProgram::solve() {
  model_->hand_over();
  solver().dual(model_->clp, 0);
  int status = solver().status(model_->clp);
  if (status != kOptimal) {  // once more by the other method, for what rounding may have done
    solver().primal(model_->clp, 0);
    status = solver().status(model_->clp);
  }
  if (status == kOptimal) return true;
  if (status == kInfeasible) return false;
  throw LimitError("the linear program for the weights could not be solved");
}

double LinearProgram::value(std::size_t variable) const {
  return solver().primal_column_solution(model_->clp)[variable];
}

std::vector<std::size_t> LinearProgram::contradiction() const {
  std::vector<std::size_t> conditions;
  const auto count = static_cast<std::size_t>(solver().number_rows(model_->clp));
  double* const ray = solver().infeasibility_ray(model_->clp);
  for (std::size_t i = 0; i < count; ++i) {
    if (ray == nullptr || std::abs(ray[i]) > kTolerance) conditions.push_back(i);
  }
  if (ray != nullptr) solver().free_ray(model_->clp, ray);
  return conditions;
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
bool LinearProgram::solve() { return false; }
double LinearProgram::value(std::size_t) const { return 0.0; }
std::vector<std::size_t> LinearProgram::contradiction() const { return {}; }

#endif

LinearProgram::LinearProgram(LinearProgram&&) noexcept = default;
LinearProgram& LinearProgram::operator=(LinearProgram&&) noexcept = default;
LinearProgram::~LinearProgram() = default;

}  // namespace orthoball
