#include "explore/metric_slopes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explore/philox.hpp"
#include "explore/variant_evaluator.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::MetricSlopes;
using explore::VariantPlan;

const std::string model1 = "model = \"model1.toml\"";
const std::string blend = "blend = [\"template.toml\", \"model1.toml\", \"model2.toml\"]";

// One group of each kind of range.
const std::string all_ranges = R"(
shape = { vary = ["shape.hood.*"], offset = [-0.05, 0.1] }
fullness = { vary = ["fullness.hood__windshield.*"], factor = [0.8, 1.1] }
cuts = { vary = ["cut.hood.*"], width = [0.02, 0.05] }
nose = { vary = ["curve.grille_bottom[0].x", "curve.grille_bottom[1].x"], offset = [-20, 30], linked = true, weights = [1, 0.5] }
roof = { vary = ["curve.roof__side_window*.z", "curve.windshield__roof*.z"], offset = [-20, 20] }
arches = { vary = ["curve.*_arch_*.x"], offset = [-5, 5] }
ends = { vary = ["curve.rear_bumper__rear_skirt*.x", "curve.grille__hood*.x"], offset = [-5, 5] }
sides = { vary = ["curve.door_upper__door_lower*.y"], offset = [-5, 5] }
tail = { vary = ["shape.tail.u*"], factor = [0.9, 1.1], linked = true }
)";

const std::string all_metrics = R"(
bending = {}
variation = {}
area = { stage = "kept", faces = ["roof"] }
fold = { stage = "base" }
closeness = {}
length = {}
width = {}
height = {}
wheelbase = {}
front_overhang = {}
rear_overhang = {}
slope = { kind = "rake", face = "windshield" }
)";
constexpr int metrics = 12;

std::shared_ptr<const VariantPlan> plan_of(const std::string& base) {
  return std::make_shared<VariantPlan>(study_of(
      study_text(base, all_ranges, all_metrics, "kind = \"star\"", "[checks]\nfolds = false")));
}

std::vector<int> all_indices() {
  std::vector<int> indices(metrics);
  for (int k = 0; k < metrics; ++k) indices[k] = k;
  return indices;
}

// In the cube, away from its faces, where central differences fit in.
Eigen::VectorXd place(int size, std::uint64_t seed) {
  const explore::PlacedRandom random(seed, 99);
  Eigen::VectorXd x(size);
  for (int k = 0; k < size; ++k) x[k] = 0.2 + 0.6 * random.uniform(0, std::uint32_t(k))[0];
  return x;
}

class Slopes : public ::testing::TestWithParam<std::string> {};

TEST_P(Slopes, ValuesAreThoseThatAStoreHolds) {
  const auto plan = plan_of(GetParam());
  MetricSlopes slopes(plan, all_indices());
  explore::VariantEvaluator evaluator(plan);
  const std::vector<double> row = slopes.space().rounded(place(slopes.space().size(), 1));
  std::vector<double> measured(metrics);
  evaluator.measure(row, measured);
  Eigen::VectorXd values;
  Eigen::MatrixXd jacobian;
  ASSERT_TRUE(slopes.evaluate(slopes.space().point(row), values, jacobian));
  // Dimensions are measured in two ways, to 1e-6 mm each; the rest differs by rounding.
  for (int k = 0; k < metrics; ++k)
    EXPECT_NEAR(values[k], measured[k], 1e-8 * std::abs(measured[k]) + 1e-5) << k;
}

// Central differences: an error of second order and one of rounding, over the step.
constexpr double step = 1e-5, slope_tolerance = 2e-5;

TEST_P(Slopes, AreThoseOfDifferences) {
  const auto plan = plan_of(GetParam());
  MetricSlopes slopes(plan, all_indices());
  const int n = slopes.space().size();
  const Eigen::VectorXd x = place(n, 2), direction = place(n, 3).array() - 0.5;
  Eigen::VectorXd values, ahead, behind;
  Eigen::MatrixXd jacobian, ignored;
  ASSERT_TRUE(slopes.evaluate(x + step * direction, ahead, ignored));
  ASSERT_TRUE(slopes.evaluate(x - step * direction, behind, ignored));
  ASSERT_TRUE(slopes.evaluate(x, values, jacobian));
  const Eigen::VectorXd expected = (ahead - behind) / (2.0 * step);
  const Eigen::VectorXd slope = jacobian * direction;
  int moving = 0;
  for (int k = 0; k < metrics; ++k) {
    const double size = jacobian.row(k).norm() * direction.norm();
    EXPECT_NEAR(slope[k], expected[k], slope_tolerance * (size + std::abs(values[k]))) << k;
    moving += jacobian.row(k).norm() > 0.0;
  }
  EXPECT_GE(moving, GetParam() == model1 ? metrics : metrics - 1);  // no face of the blend folds
}

TEST_P(Slopes, PointsAndValuesAreInverse) {
  const auto plan = plan_of(GetParam());
  const explore::SearchSpace space(plan->space);
  const Eigen::VectorXd x = place(space.size(), 4);
  std::vector<double> values(std::size_t(plan->space.column_count()));
  space.values(x, values);
  EXPECT_LT((space.point(values) - x).norm(), 1e-12);  // rounding
}

TEST_P(Slopes, RoundingIsThatOfTheStore) {
  const auto plan = plan_of(GetParam());
  const explore::SearchSpace space(plan->space);
  const std::vector<double> row = space.rounded(place(space.size(), 5));
  EXPECT_EQ(space.rounded(space.point(row)), row);
}

INSTANTIATE_TEST_SUITE_P(Each, Slopes, ::testing::Values(model1, blend));

TEST(MetricSlopes, RefusesABodyThatCannotBeBuilt) {
  const auto plan = std::make_shared<VariantPlan>(
      study_of(study_text(model1, "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 3.5] }",
                          "bending = {}", "kind = \"star\"")));
  MetricSlopes slopes(plan, {0});
  Eigen::VectorXd values;
  Eigen::MatrixXd jacobian;
  EXPECT_FALSE(slopes.evaluate(Eigen::VectorXd::Ones(slopes.space().size()), values, jacobian));
  EXPECT_TRUE(slopes.evaluate(Eigen::VectorXd::Zero(slopes.space().size()), values, jacobian));
}

TEST(MetricSlopes, KnowsWhichMetricsHaveGradients) {
  EXPECT_EQ(explore::metrics_with_gradient(),
            "bending, variation, area, fold, closeness, length, width, height, wheelbase, "
            "front_overhang, rear_overhang, rake");
}

}  // namespace
}  // namespace bodyline::testing
