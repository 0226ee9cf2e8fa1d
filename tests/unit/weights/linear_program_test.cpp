// SPDX-License-Identifier: MIT
#include "orthoball/weights/linear_program.h"

#include <gtest/gtest.h>

#include <array>

namespace orthoball {
namespace {

using Term = LinearProgram::Term;
constexpr double kInfinity = LinearProgram::kInfinity;

class LinearProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_linear_solver()) GTEST_SKIP() << "built without CLP";
  }
};

TEST_F(LinearProgramTest, FindsTheLeastCostAndGrows) {
  LinearProgram program;
  const std::size_t x = program.add_variable(0.0, 1.0), y = program.add_variable(0.0, 2.0);
  program.add_condition(4.0, kInfinity, std::array{Term{x, 1.0}, Term{y, 1.0}});
  ASSERT_EQ(program.solve(), Outcome::solved);
  EXPECT_NEAR(program.value(x), 4.0, 1e-9);
  EXPECT_NEAR(program.value(y), 0.0, 1e-9);
  program.add_condition(-kInfinity, 3.0, std::array{Term{x, 1.0}});
  const std::size_t z = program.add_variable(-kInfinity, 0.0);
  program.add_condition(5.0, 5.0, std::array{Term{y, 1.0}, Term{z, -1.0}});
  ASSERT_EQ(program.solve(), Outcome::solved);
  EXPECT_NEAR(program.value(x), 3.0, 1e-9);
  EXPECT_NEAR(program.value(y), 1.0, 1e-9);
  EXPECT_NEAR(program.value(z), -4.0, 1e-9);
}

TEST_F(LinearProgramTest, TellsThatConditionsContradictEachOther) {
  LinearProgram program;
  const std::size_t x = program.add_variable(0.0, 0.0);
  program.add_condition(3.0, kInfinity, std::array{Term{x, 1.0}});
  program.add_condition(-kInfinity, 2.0, std::array{Term{x, 1.0}});
  EXPECT_EQ(program.solve(), Outcome::infeasible);
}

TEST_F(LinearProgramTest, TellsWhatTheConditionsCost) {
  LinearProgram program;
  const std::size_t x = program.add_variable(0.0, 3.0), y = program.add_variable(0.0, 1.0);
  const std::size_t of_x = program.add_condition(2.0, kInfinity, std::array{Term{x, 2.0}});
  const std::size_t of_y = program.add_condition(-kInfinity, 5.0, std::array{Term{y, 1.0}});
  ASSERT_EQ(program.solve(), Outcome::solved);
  EXPECT_NEAR(program.price(of_x), 1.5, 1e-9);
  EXPECT_NEAR(program.price(of_y), 0.0, 1e-9);
}

}  // namespace
}  // namespace orthoball
