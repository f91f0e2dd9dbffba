// Fairness tuning of chains whose joins hold exactly (docs/families.md, section 5).

#include "optimize/fair_chain.hpp"

#include <gtest/gtest.h>

#include "model/chain_variables.hpp"
#include "model/join_measure.hpp"
#include "optimize/check_gradient.hpp"
#include "sample_patches.hpp"

namespace bodyline::testing {
namespace {

using model::PatchChain;

constexpr double normal_deg = 1e-9;
constexpr double tensor_relative = 1e-10;  // rounding times the ratios of three joins
constexpr double taylor_slope = 0.1;       // around 2
constexpr double entry_error = 1e-6;

struct Case {
  std::string family;
  int continuity;
};

// Alphas for which the patches have Bezier forms.
PatchChain tunable_chain(const Case& at) {
  std::mt19937 random(51);
  PatchChain chain = random_chain(at.family, at.continuity, random);
  for (model::FamilyPatch& patch : chain.patches) {
    for (auto* shape : {&patch.shape_u, &patch.shape_v}) {
      for (double& x : *shape) x *= 0.5;
    }
  }
  model::propagate(chain);
  return chain;
}

class FairChain : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Families, FairChain,
                         ::testing::Values(Case{"bezier-like", 1}, Case{"bezier-like", 2},
                                           Case{"h-bezier", 1}, Case{"h-bezier", 2}),
                         [](const auto& at) {
                           return at.param.family.substr(0, 1) +
                                  std::to_string(at.param.continuity);
                         });

TEST_P(FairChain, GradientIsTheDerivativeForEveryVariable) {
  const PatchChain chain = tunable_chain(GetParam());
  optimize::ChainProblemOptions options;
  options.fold = 1.0;
  optimize::ChainProblem problem(chain, model::chain_variables(chain), options);
  const optimize::GradientReport report = optimize::check_gradient(problem, problem.start());
  EXPECT_NEAR(report.worst_slope, 2.0, taylor_slope);
  EXPECT_LE(report.worst_error, entry_error);
  Eigen::VectorXd gradient(problem.size());
  problem.value(problem.start(), &gradient);
  for (Eigen::Index k = 0; k < gradient.size(); ++k) EXPECT_NE(gradient[k], 0.0) << k;
}

TEST_P(FairChain, ConvergesImprovesAndKeepsEveryJoin) {
  const PatchChain chain = tunable_chain(GetParam());
  optimize::FairChainOptions options;
  const optimize::FairChainResult result = optimize::fair_chain(chain, options);
  EXPECT_TRUE(result.status == optimize::Status::converged ||
              result.status == optimize::Status::small_improvement)
      << optimize::status_words(result.status);
  EXPECT_LT(result.end_measure, 0.9 * result.start_measure);
  for (std::size_t k = 0; k < chain.joins.size(); ++k) {
    const model::JoinMeasure measure = model::measure_join(
        result.chain.patches[k], chain.joins[k].direction, result.chain.patches[k + 1]);
    EXPECT_LE(measure.gap_mm, 1e-9);
    EXPECT_LE(measure.direction_deg, normal_deg);
    if (GetParam().continuity == 1) continue;
    EXPECT_LE(measure.curvature_jump_per_mm, tensor_relative * measure.curvature_per_mm);
  }
}

TEST_P(FairChain, MovesOnlyWhatItMay) {
  const PatchChain chain = tunable_chain(GetParam());
  optimize::FairChainOptions options;
  options.vary = {"shape.*", "point.four*"};
  options.hold = {"shape.one.*"};
  options.problem.within = 5.0;
  options.search.max_evaluations = 30;
  const optimize::FairChainResult result = optimize::fair_chain(chain, options);
  EXPECT_EQ(result.chain.patches[0].shape_u, chain.patches[0].shape_u);
  EXPECT_EQ(result.chain.patches[0].points, chain.patches[0].points);
  EXPECT_EQ(result.chain.joins[1].ratio, chain.joins[1].ratio);
  EXPECT_NE(result.chain.patches[1].shape_v, chain.patches[1].shape_v);
  double moved = 0.0;
  for (int j = 0; j <= 3; ++j) {
    const int last = chain.patches[3].degree_u;
    moved =
        std::max(moved, (result.chain.patches[3].point(last, j) - chain.patches[3].point(last, j))
                            .cwiseAbs()
                            .maxCoeff());
  }
  EXPECT_GT(moved, 0.0);
  EXPECT_LE(moved, 5.0 + 1e-9);
}

TEST(FairChain, RefusesPatternsThatMatchNothing) {
  optimize::FairChainOptions options;
  options.vary = {"shape.nose.*"};
  EXPECT_THROW(optimize::fair_chain(tunable_chain({"h-bezier", 1}), options),
               std::invalid_argument);
}

TEST(FairChain, RefusesAlphasWithoutABezierForm) {
  PatchChain chain = tunable_chain({"h-bezier", 1});
  for (double& alpha : chain.patches[0].shape_v) alpha = 20.0;
  EXPECT_THROW(optimize::fair_chain(chain, {}), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::testing
