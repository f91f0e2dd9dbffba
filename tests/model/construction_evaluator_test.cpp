// The whole evaluator: variables to weighted terms, and back.

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <numeric>

#include "construction_models.hpp"
#include "model/evaluator.hpp"

namespace bodyline::testing {
namespace {

// Of a fit over three decades; higher orders bend the line a little.
constexpr double slope_tolerance = 0.05;
// The kernels with gradient add in another order.
constexpr double value_tolerance = 1e-12;

// Weights that give all terms a part in the sum.
std::vector<model::Term> all_terms() {
  return {{model::TermKind::bending, 1.0, model::Stage::body, {}},
          {model::TermKind::variation, 1e-9, model::Stage::body, {}},
          {model::TermKind::fold, 1e5, model::Stage::body, {}},
          {model::TermKind::closeness, 1e4, model::Stage::body, {}}};
}

model::Evaluator make_evaluator(int threads, const std::vector<model::Term>& terms = all_terms()) {
  const auto context = std::make_shared<model::BodyContext>(moved_car());
  std::vector<int> all(context->map.count());
  std::iota(all.begin(), all.end(), 0);
  model::EvaluatorOptions options;
  options.terms = terms;
  options.threads = threads;
  return model::Evaluator(context, all, options);
}

// A direction in all variables at once, small for each kind.
Eigen::VectorXd random_direction(const model::Evaluator& evaluator, std::mt19937& random) {
  const std::vector<double> unit = random_numbers(random, evaluator.size());
  Eigen::VectorXd direction(evaluator.size());
  for (int k = 0; k < evaluator.size(); ++k) {
    const model::Variable& variable = evaluator.context().map.variables()[evaluator.selected()[k]];
    direction[k] = unit[k] * (variable.kind == model::ParameterKind::curve ? 0.1 : 1e-4);
  }
  return direction;
}

// Slope of log |remainder| over log t for steps t from 1 down to 0.001.
double remainder_slope(model::Evaluator& evaluator) {
  std::mt19937 random(13);
  const Eigen::VectorXd direction = random_direction(evaluator, random);
  Eigen::VectorXd start = evaluator.start(), gradient(evaluator.size());
  start += 3.0 * random_direction(evaluator, random);  // where closeness has a slope
  const double value = evaluator.evaluate(start, &gradient);
  const double slope = gradient.dot(direction);
  const int steps = 13;
  Eigen::MatrixXd powers(steps, 2);
  Eigen::VectorXd remainder(steps);
  for (int k = 0; k < steps; ++k) {
    const double t = std::pow(10.0, -0.25 * k);
    const double moved = evaluator.evaluate(start + t * direction, nullptr);
    powers.row(k) << 1.0, std::log10(t);
    remainder[k] = std::log10(std::abs(moved - value - t * slope));
  }
  return powers.colPivHouseholderQr().solve(remainder)[1];
}

TEST(ConstructionEvaluator, TaylorRemainderOfEachTermIsOfSecondOrder) {
  for (const model::Term& term : all_terms()) {
    model::Evaluator evaluator = make_evaluator(1, {term});
    EXPECT_NEAR(remainder_slope(evaluator), 2.0, slope_tolerance) << model::term_name(term.kind);
  }
}

TEST(ConstructionEvaluator, TaylorRemainderOfTheSumIsOfSecondOrder) {
  model::Evaluator evaluator = make_evaluator(1);
  EXPECT_NEAR(remainder_slope(evaluator), 2.0, slope_tolerance);
}

TEST(ConstructionEvaluator, ANetTermJoinsTheObjectiveLikeATermOfItsOwn) {
  const std::vector<model::Term> energy{{model::TermKind::bending, 1.0, model::Stage::kept, {}}};
  std::vector<model::Term> both = energy;
  both.push_back({model::TermKind::closeness, 20.0, model::Stage::body, {}});
  model::Evaluator expected = make_evaluator(1, both), plain = make_evaluator(1, energy);
  model::EvaluatorOptions options = plain.options();
  options.net_terms = {{plain.closeness(), 20.0}};
  model::Evaluator actual(plain.shared_context(), plain.selected(), options);
  std::mt19937 random(5);
  const Eigen::VectorXd x = actual.start() + random_direction(actual, random);
  Eigen::VectorXd expected_gradient(x.size()), gradient(x.size());
  EXPECT_EQ(actual.evaluate(x, &gradient), expected.evaluate(x, &expected_gradient));
  EXPECT_EQ(gradient, expected_gradient);
  EXPECT_EQ(actual.net_term_values().front(), expected.term_values().back());
  EXPECT_GT(actual.net_term_values().front(), 0.0);
}

TEST(ConstructionEvaluator, BuildsAsFarAsItIsAskedTo) {
  model::Evaluator base =
      make_evaluator(1, {{model::TermKind::bending, 1.0, model::Stage::base, {}}});
  model::EvaluatorOptions options = base.options();
  options.stage = model::Stage::body;
  model::Evaluator body(base.shared_context(), base.selected(), options);
  body.build(body.start());
  const model::Face& last = body.context().plan.body_faces.back();
  EXPECT_GT(Eigen::Map<const Eigen::Vector3d>(body.nets() + 3 * last.net).norm(), 0.0);
}

TEST(ConstructionEvaluator, BuildsFromParametersWhatItBuildsFromTheirVariables) {
  model::Evaluator one = make_evaluator(1), other = make_evaluator(1);
  std::mt19937 random(6);
  one.build(one.start() + random_direction(one, random));
  other.build_parameters(one.parameters());
  const int numbers = 3 * one.context().plan.point_count;
  EXPECT_TRUE(std::equal(one.nets(), one.nets() + numbers, other.nets()));
  EXPECT_THROW(other.build_parameters(Eigen::VectorXd::Zero(3)), std::invalid_argument);
}

TEST(ConstructionEvaluator, ResultsHaveTheSameBitsForAnyNumberOfThreads) {
  model::Evaluator one = make_evaluator(1);
  const Eigen::VectorXd x = one.start();
  Eigen::VectorXd expected(one.size()), actual(one.size());
  const double plain_value = one.evaluate(x, nullptr), value = one.evaluate(x, &expected);
  for (const int threads : {2, 3, 5}) {
    model::Evaluator several = make_evaluator(threads);
    EXPECT_EQ(several.evaluate(x, nullptr), plain_value);
    for (int repeat = 0; repeat < 20; ++repeat) {
      EXPECT_EQ(several.evaluate(x, &actual), value);
      EXPECT_EQ(actual, expected);
      EXPECT_EQ(several.term_values(), one.term_values());
    }
  }
}

TEST(ConstructionEvaluator, ValueIsTheSameWithAndWithoutGradient) {
  model::Evaluator evaluator = make_evaluator(1);
  const Eigen::VectorXd x = evaluator.start();
  Eigen::VectorXd gradient(evaluator.size());
  const double with = evaluator.evaluate(x, &gradient), without = evaluator.evaluate(x, nullptr);
  EXPECT_NEAR(with, without, value_tolerance * with);
}

}  // namespace
}  // namespace bodyline::testing
