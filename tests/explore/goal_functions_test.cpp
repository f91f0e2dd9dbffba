#include "explore/goal_functions.hpp"

#include <gtest/gtest.h>

#include "study_support.hpp"

namespace bodyline::testing {
namespace {

// A search ends on its bounds up to rounding, so a body exactly on one must already count as
// outside, by the same part of the bound's size whatever the bound is: of 0 too.
TEST(GoalFunctions, KeepConstraintsInsideTheirBounds) {
  const auto evaluated = [](const std::string& rest) {
    const auto plan = std::make_shared<explore::VariantPlan>(study_of(
        "format = 1\nname = \"test\"\nmodel = \"model1.toml\"\n[variables]\n"
        "fullness = { vary = [\"fullness.hood__*\"], range = [1.0, 2.0] }\n[metrics]\n"
        "bending = {}\ncloseness = {}\n[optimizer]\nkind = \"local\"\nminimize = [\"bending\"]\n"
        "algorithm = \"nlopt-slsqp\"\nstarts = { kind = \"star\" }\n" +
        rest));
    explore::GoalFunctions functions(plan, explore::GoalFunctions::Goals::summed);
    const std::vector<double> start = plan->space.start_values();
    Eigen::VectorXd values;
    Eigen::MatrixXd jacobian;
    EXPECT_TRUE(functions.evaluate(functions.space().point(start), values, jacobian));
    return values;
  };
  // Of the model itself, which is 0.
  const Eigen::VectorXd values = evaluated("[constraints]\ncloseness = { most = 0 }");
  ASSERT_EQ(values.size(), 2);
  EXPECT_GT(values[1], 0.0);
}

}  // namespace
}  // namespace bodyline::testing
