// Fits that cannot go on, and options that make no sense.

#include "optimize/fit_body.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "io/read_model.hpp"
#include "optimize/net_rows.hpp"

namespace bodyline::optimize {
namespace {

using testing::HasSubstr;

model::Model start_model() { return io::read_model(BODYLINE_SOURCE_DIR "/cars/template.toml"); }

/// No number wherever the body reaches farther back than it does in the template.
class OnlyAsFar : public FitTarget {
 public:
  OnlyAsFar(const model::BodyPlan& plan, model::Stage stage)
      : term_(std::make_shared<NetRows>(plan, stage)), count_(plan.point_count) {}
  void match(const double* nets, const FitRound&) override {
    double furthest = 0.0;
    for (int k = 0; k < count_; ++k) furthest = std::max(furthest, nets[3 * k]);
    constexpr double tail = 5000.0;  // mm; that of the template is at 4734
    NetRow row;
    row.offset = furthest > tail ? std::nan("") : 0.0;
    row.lower = row.upper = 0.0;
    excess_ = row.offset;
    term_->set({row});
  }
  model::WeightedNetTerm term() const override { return {term_, 1.0}; }
  double excess() const override { return excess_; }

 private:
  std::shared_ptr<NetRows> term_;
  int count_;
  double excess_ = 0.0;
};

TEST(FitBody, AStartThatCannotBeEvaluatedDoesNotWin) {
  const FitTargetMaker target = [](const model::BodyPlan& plan, model::Stage stage, FitDetail) {
    return std::make_unique<OnlyAsFar>(plan, stage);
  };
  FitOptions options;
  options.warp_rounds = options.curve_rounds = options.body_rounds = 1;
  options.unfold_rounds = 0;
  const FitStart good, bad{{1000.0, 0.0, 0.0}, 0.0};
  for (const auto& starts : {std::vector{bad, good}, std::vector{good, bad}}) {
    options.starts = starts;
    const FitResult result = fit_body({target}, start_model(), options);
    EXPECT_NE(result.status, Status::failed);
    double furthest = 0.0;
    for (const model::Curve& curve : result.model.curves)
      for (const Eigen::Vector3d& point : curve.points) furthest = std::max(furthest, point.x());
    EXPECT_LT(furthest, 5000.0);
  }
}

TEST(FitBody, APhaseEndsWhereARoundFails) {
  const FitTargetMaker target = [](const model::BodyPlan& plan, model::Stage stage, FitDetail) {
    return std::make_unique<OnlyAsFar>(plan, stage);
  };
  FitOptions options;
  options.starts = {FitStart{{1000.0, 0.0, 0.0}, 0.0}};
  const FitResult result = fit_body({target}, start_model(), options);
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_EQ(result.history.size(), 3U);  // warp, curves, body
}

TEST(FitOptions, ThatAreOutOfRangeAreRefusedByName) {
  const auto refusal = [](const auto& change) -> std::string {
    FitOptions options;
    change(options);
    try {
      check_fit_options(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([](FitOptions&) {}), "");
  EXPECT_THAT(refusal([](FitOptions& o) { o.starts.clear(); }), HasSubstr(" starts "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.starts[1].move.x() = NAN; }), HasSubstr(" starts "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.warp_rounds = -1; }), HasSubstr(" warp_rounds "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.unfold_rounds = -1; }), HasSubstr(" unfold_rounds "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.far = INFINITY; }), HasSubstr(" far "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.near = 0.0; }), HasSubstr(" near "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.near = 2.0 * o.far; }), HasSubstr(" near "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.rim_near = NAN; }), HasSubstr(" rim_near "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.bending = -1.0; }), HasSubstr(" bending "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.fold = NAN; }), HasSubstr(" fold "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.stay = -1.0; }), HasSubstr(" stay "));
  EXPECT_THAT(refusal([](FitOptions& o) { o.rims = INFINITY; }), HasSubstr(" rims "));
  FitOptions options;
  options.rims = -1.0;
  EXPECT_THROW(fit_body({}, start_model(), options), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::optimize
