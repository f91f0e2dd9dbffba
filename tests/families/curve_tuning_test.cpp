// Fairness tuning of chains of curves whose joins hold exactly (docs/families.md, section 5).

#include <gtest/gtest.h>

#include <cmath>

#include "model/curve_chain_variables.hpp"
#include "optimize/check_gradient.hpp"
#include "optimize/fair_chain.hpp"
#include "sample_patches.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::CurveChain;
using model::CurveFairness;

constexpr double gap_mm = 1e-9, turn_deg = 1e-9;
constexpr double curvature_relative = 1e-10;  // rounding times the ratios of the joins
constexpr double taylor_slope = 0.1;          // around 2
constexpr double entry_error = 1e-6;
constexpr double quadrature_relative = 1e-10;

struct Case {
  std::string family;
  int continuity;
  bool closed;
  CurveFairness measure;
};

// Four bumpy curves around a square of 300 mm.
CurveChain curve_chain(const Case& at) {
  std::mt19937 random(77);
  CurveChain chain;
  chain.name = "square";
  const Vector3d corners[] = {{0, 0, 0}, {300, 0, 20}, {300, 300, 0}, {0, 300, -20}};
  // A cubic has no point left for a closing join behind one with G2; only Bezier-like curves have
  // more.
  const int degree = at.family == "bezier-like" ? 5 : 3;
  for (int c = 0; c < 4; ++c) {
    model::FamilyCurve curve = random_curve(at.family, degree, random);
    curve.name = "c" + std::to_string(c);
    const Vector3d from = corners[c], to = corners[(c + 1) % 4];
    const Vector3d out = Vector3d(0.15, 0.15, 0.02).cwiseProduct(from + to - Vector3d(300, 300, 0));
    for (int k = 0; k <= degree; ++k) {
      const double t = double(k) / degree;
      const Vector3d bump = 0.3 * (curve.points[k] - Vector3d(300.0 * t, 0, 0));
      curve.points[k] = (1 - t) * from + t * to + 4 * t * (1 - t) * out + bump;
    }
    chain.curves.push_back(curve);
  }
  const int joins = at.closed ? 4 : 3;
  for (int j = 0; j < joins; ++j) {
    // The closing join is G1, and so is the one before it where its curve is a cubic.
    const bool bends = at.continuity == 2 && j < 3 && (j < 2 || degree > 3 || !at.closed);
    chain.joins.push_back({bends ? 2 : 1, 0.8 + 0.1 * j, bends ? 0.1 * j : 0.0});
  }
  model::propagate(chain);
  return chain;
}

void expect_joined(const CurveChain& chain) {
  for (std::size_t j = 0; j < chain.joins.size(); ++j) {
    const model::JoinMeasure measure = model::measure_join(chain, int(j));
    EXPECT_LE(measure.gap_mm, gap_mm) << j;
    EXPECT_LE(measure.direction_deg, turn_deg) << j;
    if (chain.joins[j].continuity == 1) continue;
    EXPECT_LE(measure.curvature_jump_per_mm, curvature_relative * measure.curvature_per_mm) << j;
  }
}

optimize::FairCurveChainOptions options_of(const Case& at) {
  optimize::FairCurveChainOptions options;
  options.problem.measure = at.measure;
  return options;
}

class FairCurves : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Families, FairCurves,
                         ::testing::Values(Case{"bezier-like", 1, false, CurveFairness::bending},
                                           Case{"bezier-like", 2, true, CurveFairness::bending},
                                           Case{"bezier-like", 2, true, CurveFairness::variation},
                                           Case{"h-bezier", 1, true, CurveFairness::bending},
                                           Case{"h-bezier", 1, true, CurveFairness::variation},
                                           Case{"h-bezier", 2, false, CurveFairness::bending},
                                           Case{"h-bezier", 2, true, CurveFairness::variation}),
                         [](const auto& at) {
                           return at.param.family.substr(0, 1) +
                                  std::to_string(at.param.continuity) +
                                  (at.param.closed ? "_closed" : "_open") +
                                  (at.param.measure == CurveFairness::bending ? "_bending"
                                                                              : "_variation");
                         });

TEST_P(FairCurves, GradientIsTheDerivativeForEveryVariable) {
  const CurveChain chain = curve_chain(GetParam());
  optimize::CurveChainProblem problem(chain, model::chain_variables(chain),
                                      options_of(GetParam()).problem);
  const optimize::GradientReport report = optimize::check_gradient(problem, problem.start());
  EXPECT_NEAR(report.worst_slope, 2.0, taylor_slope);
  EXPECT_LE(report.worst_error, entry_error);
  Eigen::VectorXd gradient(problem.size());
  problem.value(problem.start(), &gradient);
  for (Eigen::Index k = 0; k < gradient.size(); ++k)
    EXPECT_NE(gradient[k], 0.0) << problem.variables()[k].name;
}

TEST_P(FairCurves, ImprovesAndKeepsEveryJoin) {
  const CurveChain chain = curve_chain(GetParam());
  const optimize::FairCurveChainResult result = optimize::fair_chain(chain, options_of(GetParam()));
  EXPECT_TRUE(result.status == optimize::Status::converged ||
              result.status == optimize::Status::small_improvement)
      << optimize::status_words(result.status);
  EXPECT_LT(result.end_measure, 0.95 * result.start_measure);
  expect_joined(result.chain);
}

TEST_P(FairCurves, TunedChainStays) {
  const optimize::FairCurveChainOptions options = options_of(GetParam());
  const optimize::FairCurveChainResult once =
      optimize::fair_chain(curve_chain(GetParam()), options);
  const optimize::FairCurveChainResult again = optimize::fair_chain(once.chain, options);
  EXPECT_LE(again.end_measure, once.end_measure);
  EXPECT_NEAR(again.end_measure, once.end_measure, 1e-5 * once.end_measure);
}

TEST_P(FairCurves, JoinsHoldForEveryValueOfEveryVariable) {
  const CurveChain chain = curve_chain(GetParam());
  const model::CurveChainLayout layout(chain);
  const Eigen::VectorXd numbers = model::to_numbers(chain, layout);
  for (const model::ChainVariable& variable : model::chain_variables(chain)) {
    const double value = numbers[variable.members[0]];
    const double other = variable.kind == model::ChainKind::point
                             ? value + 20.0
                             : 0.5 * (value + std::min(variable.upper, 6.0));
    Eigen::VectorXd moved = numbers;
    for (const int member : variable.members) moved[member] = other;
    CurveChain changed = chain;
    model::set_numbers(changed, layout, moved);
    // With all points fixed a join holds where the variable says so.
    bool holds = true;
    for (std::size_t j = 0; j < chain.joins.size(); ++j) {
      const model::JoinMeasure measure = model::measure_join(changed, int(j));
      holds = holds && measure.direction_deg < 1e-7 &&
              (chain.joins[j].continuity == 1 ||
               measure.curvature_jump_per_mm < 1e-8 * measure.curvature_per_mm);
    }
    if (variable.kind == model::ChainKind::shape) {
      EXPECT_EQ(holds, variable.points_stay) << variable.name;
    }
    model::propagate(changed);
    expect_joined(changed);
  }
}

TEST(FairCurves, FreePointsMoveAsFarAsTheyMay) {
  const CurveChain chain = curve_chain({"h-bezier", 1, true, CurveFairness::bending});
  optimize::FairCurveChainOptions options;
  options.vary = {"point.c1*"};
  options.problem.within = 5.0;
  const optimize::FairCurveChainResult result = optimize::fair_chain(chain, options);
  EXPECT_EQ(result.variables.size(), 6U);  // two of four points are determined
  EXPECT_EQ(result.chain.curves[0].points, chain.curves[0].points);
  EXPECT_EQ(result.chain.curves[1].shape, chain.curves[1].shape);
  EXPECT_NEAR((result.end_values - result.start_values).cwiseAbs().maxCoeff(), 5.0, 1e-9);
  expect_joined(result.chain);
}

// On a straight line nothing is left to gain, whatever its shape parameters are.
TEST(FairCurves, StraightChainStays) {
  CurveChain chain;
  for (const char* name : {"one", "two"}) {
    const double x = chain.curves.empty() ? 0.0 : 30.0;
    chain.curves.push_back(
        {name, "h-bezier", {{x, 0, 0}, {x + 8, 0, 0}, {x + 20, 0, 0}, {x + 30, 0, 0}}, {1, 2, 3}});
  }
  chain.joins = {{1, 1.0, 0.0}};
  model::propagate(chain);
  const optimize::FairCurveChainResult result =
      optimize::fair_chain(chain, optimize::FairCurveChainOptions{});
  EXPECT_EQ(result.end_measure, 0.0);
  for (int c = 0; c < 2; ++c) {
    EXPECT_EQ(result.chain.curves[c].shape, chain.curves[c].shape);
    EXPECT_EQ(result.chain.curves[c].points, chain.curves[c].points);
  }
}

// y = x^2 / 2 from x = 0 to 1; with x = tan a the curvature is cos^3 a and ds = da / cos^3 a.
TEST(CurveFairnessOf, AParabolaIsThatOfItsClosedForm) {
  const model::FamilyCurve parabola{
      "parabola",
      "h-bezier",
      {{0, 0, 0}, {1.0 / 3, 0, 0}, {2.0 / 3, 0, 1.0 / 6}, {1, 0, 0.5}},
      {0, 0, 0}};
  const model::GaussRule rule = model::curve_rule(4.0);
  const double s = 1.0 / std::sqrt(2.0);  // sin a at the end
  const double bending = s - s * s * s / 3;
  const double variation = 9 * (std::pow(s, 3) / 3 - 3 * std::pow(s, 5) / 5 +
                                3 * std::pow(s, 7) / 7 - std::pow(s, 9) / 9);
  EXPECT_NEAR(model::fairness(parabola, CurveFairness::bending, rule), bending,
              quadrature_relative * bending);
  EXPECT_NEAR(model::fairness(parabola, CurveFairness::variation, rule), variation,
              quadrature_relative * variation);
}

// The nodes follow the turns at the ends of curves with large alphas.
TEST(CurveFairnessOf, CurvesWithLargeAlphasIsResolved) {
  for (const double alpha : {0.0, 3.0, 20.0, 50.0}) {
    const model::FamilyCurve curve{"curve",
                                   "h-bezier",
                                   {{0, 0, 0}, {40, 30, 0}, {80, 40, 10}, {120, 0, 0}},
                                   {alpha, 0.5 * alpha, 0.8 * alpha}};
    const double value = model::fairness(curve, CurveFairness::bending, model::curve_rule(alpha));
    const double finer =
        model::fairness(curve, CurveFairness::bending, model::curve_rule(100.0 * alpha + 1000.0));
    EXPECT_NEAR(value, finer, 1e-5 * finer) << alpha;
  }
}

TEST(CurveFairnessOf, AnUnknownNameIsRefused) {
  EXPECT_THROW(model::curve_fairness("tension"), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::testing
