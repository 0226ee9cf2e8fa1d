// SPDX-License-Identifier: MIT
#include "orthoball/weights/linear_program.h"

#include "orthoball/error.h"

#ifdef ORTHOBALL_CLP

#include <Clp_C_Interface.h>

#include <cmath>

namespace orthoball {
namespace {

constexpr double kTolerance = 1e-9;
constexpr int kOptimal = 0, kInfeasible = 1;  // what Clp_status says

}  // namespace

struct LinearProgram::Model {
  Model() : clp(Clp_newModel()) {
    Clp_setLogLevel(clp, 0);
    Clp_setPrimalTolerance(clp, kTolerance);
    Clp_setDualTolerance(clp, kTolerance);
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  ~Model() { Clp_deleteModel(clp); }

  // Hands over what was added since the last time.
  void hand_over() {
    const std::vector<CoinBigIndex> no_terms(costs.size() + 1);
    const std::vector<double> no_limit(costs.size(), kInfinity);
    const int no_row = 0;
    const double no_number = 0.0;
    Clp_addColumns(clp, static_cast<int>(costs.size()), least_values.data(), no_limit.data(),
                   costs.data(), no_terms.data(), &no_row, &no_number);
    Clp_addRows(clp, static_cast<int>(least_sums.size()), least_sums.data(), most_sums.data(),
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

bool has_linear_solver() { return true; }

LinearProgram::LinearProgram() : model_(std::make_unique<Model>()) {}

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
  Clp_dual(model_->clp, 0);
  int status = Clp_status(model_->clp);
  if (status != kOptimal) {  // once more by the other method, for what rounding may have done
    Clp_primal(model_->clp, 0);
    status = Clp_status(model_->clp);
  }
  if (status == kOptimal) return true;
  if (status == kInfeasible) return false;
  throw LimitError("the linear program for the weights could not be solved");
}

double LinearProgram::value(std::size_t variable) const {
  return Clp_primalColumnSolution(model_->clp)[variable];
}

std::vector<std::size_t> LinearProgram::contradiction() const {
  std::vector<std::size_t> conditions;
  const auto count = static_cast<std::size_t>(Clp_numberRows(model_->clp));
  double* const ray = Clp_infeasibilityRay(model_->clp);
  for (std::size_t i = 0; i < count; ++i) {
    if (ray == nullptr || std::abs(ray[i]) > kTolerance) conditions.push_back(i);
  }
  if (ray != nullptr) Clp_freeRay(model_->clp, ray);
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
