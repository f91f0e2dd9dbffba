// The pullback of the whole construction against the complex step through the same construction.

#include <gtest/gtest.h>

#include <complex>

#include "construction_models.hpp"
#include "model/construction.hpp"

namespace bodyline::testing {
namespace {

using Complex = std::complex<double>;

// Both derivatives are exact but for rounding; adjoints of a thousand points add up in each.
constexpr double gradient_tolerance = 1e-10;
constexpr double complex_step = 1e-100;

Eigen::VectorXd pullback_gradient(const SampleBody& body, model::Stage stage,
                                  const std::vector<double>& nets_bar) {
  model::Construction<double> construction(body.plan);
  construction.build(body.parameters.data(), stage);
  for (int k = 0; k < body.plan.point_count; ++k) {
    construction.nets_bar[k] = {nets_bar[3 * k], nets_bar[3 * k + 1], nets_bar[3 * k + 2]};
  }
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(body.parameters.size());
  construction.pullback(body.parameters.data(), stage, gradient.data());
  return gradient;
}

Eigen::VectorXd complex_gradient(const SampleBody& body, model::Stage stage,
                                 const std::vector<double>& nets_bar) {
  model::Construction<Complex> construction(body.plan);
  Eigen::VectorXcd parameters = body.parameters.cast<Complex>();
  Eigen::VectorXd gradient(parameters.size());
  for (int p = 0; p < parameters.size(); ++p) {
    parameters[p] += Complex(0.0, complex_step);
    construction.build(parameters.data(), stage);
    parameters[p] = body.parameters[p];
    double sum = 0.0;
    for (int k = 0; k < body.plan.point_count; ++k) {
      const model::Vec3<Complex>& at = construction.nets[k];
      sum += nets_bar[3 * k] * at.x.imag() + nets_bar[3 * k + 1] * at.y.imag() +
             nets_bar[3 * k + 2] * at.z.imag();
    }
    gradient[p] = sum / complex_step;
  }
  return gradient;
}

class ConstructionGradient
    : public ::testing::TestWithParam<std::tuple<std::string, model::Stage>> {};

TEST_P(ConstructionGradient, PullbackIsTheComplexStepDerivativeForEveryParameter) {
  const auto& [name, stage] = GetParam();
  const SampleBody body = make_body(name);
  std::mt19937 random(7);
  std::vector<double> nets_bar = random_numbers(random, 3 * body.plan.point_count);
  // Nets beyond the stage are not built.
  const int built = stage == model::Stage::base   ? body.plan.kept_begin
                    : stage == model::Stage::kept ? body.plan.kept_begin * 2
                                                  : body.plan.point_count;
  std::fill(nets_bar.begin() + 3 * built, nets_bar.end(), 0.0);
  // A face without a seam has no blend to move.
  for (const model::CornerStep& corner : body.plan.corners) {
    if (!corner.shape.seam) std::fill_n(nets_bar.begin() + 3 * corner.blend, 3, 0.0);
  }
  const Eigen::VectorXd expected = complex_gradient(body, stage, nets_bar);
  const Eigen::VectorXd actual = pullback_gradient(body, stage, nets_bar);
  for (int p = 0; p < expected.size(); ++p) {
    const double scale = block_scale(body.plan.layout, body.plan.layout.kind(p), expected);
    EXPECT_NEAR(actual[p], expected[p], gradient_tolerance * scale) << "parameter " << p;
  }
  EXPECT_GT(expected.norm(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, ConstructionGradient,
                         ::testing::Combine(::testing::ValuesIn(body_names()),
                                            ::testing::Values(model::Stage::base,
                                                              model::Stage::kept,
                                                              model::Stage::body)),
                         [](const auto& at) {
                           return std::get<0>(at.param) + "_" +
                                  model::stage_name(std::get<1>(at.param));
                         });

}  // namespace
}  // namespace bodyline::testing
