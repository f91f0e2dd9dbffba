// The construction of several steps at once is the same function as that of one step at a time.

#include <gtest/gtest.h>

#include "construction_models.hpp"
#include "model/body_builder.hpp"
#include "model/construction.hpp"

namespace bodyline::testing {
namespace {

// Both add the same numbers in other orders, with and without fused multiplication.
constexpr double builder_tolerance = 1e-12;

class ConstructionBuilder : public ::testing::TestWithParam<std::tuple<std::string, model::Isa>> {
 protected:
  void SetUp() override {
    if (!model::isa_available(std::get<1>(GetParam()))) GTEST_SKIP() << "not on this machine";
  }
};

TEST_P(ConstructionBuilder, NetsAgreeWithOneStepAtATime) {
  const SampleBody body = make_body(std::get<0>(GetParam()));
  model::Construction<double> one(body.plan);
  const auto several = model::make_body_builder(body.plan, std::get<1>(GetParam()));
  one.build(body.parameters.data(), model::Stage::body);
  several->build(body.parameters.data(), model::Stage::body);
  const double* expected = &one.nets[0].x;
  const double scale =
      Eigen::Map<const Eigen::VectorXd>(expected, 3 * body.plan.point_count).cwiseAbs().maxCoeff();
  for (int k = 0; k < 3 * body.plan.point_count; ++k) {
    EXPECT_NEAR(several->nets()[k], expected[k], builder_tolerance * scale) << "number " << k;
  }
}

TEST_P(ConstructionBuilder, AdjointsAgreeWithOneStepAtATime) {
  const SampleBody body = make_body(std::get<0>(GetParam()));
  model::Construction<double> one(body.plan);
  const auto several = model::make_body_builder(body.plan, std::get<1>(GetParam()));
  std::mt19937 random(11);
  const std::vector<double> nets_bar = random_numbers(random, 3 * body.plan.point_count);
  for (const model::Stage stage : {model::Stage::base, model::Stage::kept, model::Stage::body}) {
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(body.parameters.size()), actual = expected;
    one.build(body.parameters.data(), stage);
    std::copy(nets_bar.begin(), nets_bar.end(), &one.nets_bar[0].x);
    one.pullback(body.parameters.data(), stage, expected.data());
    several->build(body.parameters.data(), stage);
    std::copy(nets_bar.begin(), nets_bar.end(), several->nets_bar());
    several->pullback(body.parameters.data(), stage, actual.data());
    for (int p = 0; p < expected.size(); ++p) {
      const double scale = block_scale(body.plan.layout, body.plan.layout.kind(p), expected);
      EXPECT_NEAR(actual[p], expected[p], builder_tolerance * scale) << "parameter " << p;
    }
  }
}

std::string case_name(const ::testing::TestParamInfo<std::tuple<std::string, model::Isa>>& at) {
  const char* const sets[] = {"baseline", "avx2", "avx512"};
  return std::get<0>(at.param) + "_" + sets[static_cast<int>(std::get<1>(at.param))];
}

INSTANTIATE_TEST_SUITE_P(Bodies, ConstructionBuilder,
                         ::testing::Combine(::testing::ValuesIn(body_names()),
                                            ::testing::Values(model::Isa::baseline,
                                                              model::Isa::avx2,
                                                              model::Isa::avx512)),
                         case_name);

}  // namespace
}  // namespace bodyline::testing
