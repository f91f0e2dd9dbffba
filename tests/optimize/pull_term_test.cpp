// Foot points on faces, moments of points, and the term of an objective made of them.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "io/read_model.hpp"
#include "model/build.hpp"
#include "model/evaluator.hpp"
#include "optimize/pull_term.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Newton takes a dozen steps; near the corner of a Gregory term, which is rough there, that is not
// enough.
constexpr double foot_tolerance = 1e-3;  // mm
// Sums of a thousand terms of size 1e7 that nearly cancel.
constexpr double sum_tolerance = 1e-6;

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * double(random()) / double(std::mt19937::max());
}

/// The car's nets at a stage.
struct Car {
  explicit Car(model::Stage chosen)
      : stage(chosen),
        context(std::make_shared<const model::BodyContext>(
            io::read_model(BODYLINE_SOURCE_DIR "/cars/model2.toml"))) {
    model::EvaluatorOptions options;
    options.stage = stage;
    evaluator = std::make_unique<model::Evaluator>(
        context, context->map.select(std::vector<std::string>{"*"}), options);
    evaluator->build_parameters(context->parameters);
  }
  const double* nets() const { return evaluator->nets(); }

  model::Stage stage;
  std::shared_ptr<const model::BodyContext> context;
  std::unique_ptr<model::Evaluator> evaluator;
};

/// Points up to `away` mm off the left half of the body, with its normals.
model::Scan points_near(const model::Model& car, model::Stage stage, int count, double away) {
  std::mt19937 random(7);
  const auto faces = model::build(car, stage, model::Halves::left_and_central);
  model::Scan scan;
  for (int k = 0; k < count; ++k) {
    const model::Surface& face = faces[k % faces.size()];
    const double u = uniform(random, 0.1, 0.9), v = uniform(random, 0.1, 0.9);
    const Vector3d normal = model::outward_normal(face, u, v);
    scan.points.push_back(model::jet(face, u, v, 0).d[0] + uniform(random, -away, away) * normal);
    scan.normals.push_back(normal);
  }
  return scan;
}

std::vector<MatchPull> some_pulls(const model::Scan& scan, const std::vector<Match>& matches) {
  std::vector<MatchPull> pulls;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const Vector3d& n = matches[k].normal;
    pulls.push_back({scan.points[k], (1.0 + double(k % 3)) * n * n.transpose() +
                                         0.1 * Eigen::Matrix3d::Identity()});
  }
  return pulls;
}

class FootPoints : public testing::TestWithParam<model::Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, FootPoints,
                         testing::Values(model::Stage::base, model::Stage::body),
                         [](const auto& i) { return std::string(model::stage_name(i.param)); });

TEST_P(FootPoints, OffsetsAreAlongTheNormalInsideOfAFace) {
  const Car car(GetParam());
  const model::Scan scan =
      points_near(io::read_model(BODYLINE_SOURCE_DIR "/cars/model2.toml"), GetParam(), 2000, 3.0);
  const auto matches = ScanMatcher(car.context->plan, GetParam(), scan).match(car.nets());
  int inside = 0;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const Match& match = matches[k];
    if (match.u <= 0.0 || match.u >= 1.0 || match.v <= 0.0 || match.v >= 1.0) continue;
    ++inside;
    const Vector3d offset = scan.points[k] - match.foot;
    EXPECT_LE((offset - offset.dot(match.normal) * match.normal).norm(), foot_tolerance);
  }
  EXPECT_GT(inside, 1500);
}

TEST_P(FootPoints, NoPointIsFartherThanItWasPut) {
  const Car car(GetParam());
  const model::Scan scan =
      points_near(io::read_model(BODYLINE_SOURCE_DIR "/cars/model2.toml"), GetParam(), 2000, 0.0);
  MatchOptions options;
  options.candidates = 3;
  int away = 0;
  for (const Match& match :
       ScanMatcher(car.context->plan, GetParam(), scan, options).match(car.nets())) {
    away += std::abs(match.distance) > foot_tolerance;
  }
  EXPECT_EQ(away, 0);
}

TEST_P(FootPoints, AgreeBetweenInstructionSets) {
  const Car car(GetParam());
  const model::Scan scan =
      points_near(io::read_model(BODYLINE_SOURCE_DIR "/cars/model2.toml"), GetParam(), 500, 5.0);
  const auto expected =
      ScanMatcher(car.context->plan, GetParam(), scan, {}, model::Isa::baseline).match(car.nets());
  for (const model::Isa isa : {model::Isa::avx2, model::Isa::avx512}) {
    if (!model::isa_available(isa)) continue;
    const auto actual = ScanMatcher(car.context->plan, GetParam(), scan, {}, isa).match(car.nets());
    for (std::size_t k = 0; k < actual.size(); ++k)
      EXPECT_NEAR(actual[k].distance, expected[k].distance, foot_tolerance);
  }
}

TEST(PullTerm, ValueIsTheWeightedMeanOfSquares) {
  Car car(model::Stage::body);
  const model::Scan scan =
      points_near(io::read_model(BODYLINE_SOURCE_DIR "/cars/model2.toml"), car.stage, 1000, 4.0);
  const auto matches = ScanMatcher(car.context->plan, car.stage, scan).match(car.nets());
  const auto pulls = some_pulls(scan, matches);
  PullTerm term(car.context->plan, car.stage);
  term.set(matches, pulls);
  double sum = 0.0, weights = 0.0;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (car.context->plan.faces(car.stage)[matches[k].face].blend >= 0) continue;
    const Vector3d r = matches[k].foot - scan.points[k];
    sum += r.dot(pulls[k].weight * r);
    weights += pulls[k].weight.trace();
  }
  EXPECT_GT(sum, 1.0);
  EXPECT_NEAR(term.value(car.nets(), 1.0, nullptr), sum / weights, sum_tolerance);
}

TEST(PullTerm, AdjointIsTheDerivativeByEveryNumberOfTheNets) {
  Car car(model::Stage::body);
  const model::Scan scan =
      points_near(io::read_model(BODYLINE_SOURCE_DIR "/cars/model2.toml"), car.stage, 1000, 4.0);
  const auto matches = ScanMatcher(car.context->plan, car.stage, scan).match(car.nets());
  PullTerm term(car.context->plan, car.stage);
  term.set(matches, some_pulls(scan, matches));
  const std::size_t count = 3 * std::size_t(car.context->plan.point_count);
  std::vector<double> nets(car.nets(), car.nets() + count), bar(count, 0.0);
  term.value(nets.data(), 2.0, bar.data());
  double largest = 0.0;
  for (std::size_t k = 0; k < count; k += 5) {
    // Of a quadratic function central differences are exact whatever the step.
    constexpr double step = 10.0;
    const double kept = nets[k];
    nets[k] = kept + step;
    const double above = term.value(nets.data(), 1.0, nullptr);
    nets[k] = kept - step;
    const double below = term.value(nets.data(), 1.0, nullptr);
    nets[k] = kept;
    EXPECT_NEAR(bar[k], 2.0 * (above - below) / (2.0 * step), sum_tolerance);
    largest = std::max(largest, std::abs(bar[k]));
  }
  EXPECT_GT(largest, 1e-3);
}

TEST(PullTerm, ResidualsHaveItsValueAndGradient) {
  Car car(model::Stage::base);
  const model::Scan scan =
      points_near(io::read_model(BODYLINE_SOURCE_DIR "/cars/model2.toml"), car.stage, 600, 4.0);
  const auto matches = ScanMatcher(car.context->plan, car.stage, scan).match(car.nets());
  PullTerm term(car.context->plan, car.stage);
  term.set(matches, some_pulls(scan, matches));
  const Eigen::Index count = 3 * Eigen::Index(car.context->plan.point_count);
  VectorXd bar = VectorXd::Zero(count), residual(term.residual_count());
  const double value = term.value(car.nets(), 1.0, bar.data());
  model::NetTerm::Jacobian jacobian;
  term.residuals(car.nets(), residual, &jacobian);
  EXPECT_GT(value, 0.1);
  // Half of the digits go where directions that no point sees are left out.
  EXPECT_NEAR(residual.squaredNorm(), value, 1e-5 * value);
  const VectorXd gradient = 2.0 * (jacobian.transpose() * residual);
  EXPECT_LE((gradient - bar).norm(), 1e-5 * bar.norm());
}

}  // namespace
}  // namespace bodyline::optimize
