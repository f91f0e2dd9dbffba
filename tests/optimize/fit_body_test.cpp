// Fits that cannot go on, and options that make no sense.

#include "optimize/fit_body.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "io/read_model.hpp"
#include "model/build.hpp"
#include "model/measures.hpp"
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

/// Misfits by the stage and by whether the roof reaches back as far as that of an estate car.
class JudgesRoofs : public FitTarget {
 public:
  struct Misfits {
    double saloon, estate;
  };
  JudgesRoofs(const model::BodyPlan& plan, model::Stage stage, Misfits misfits)
      : term_(std::make_shared<NetRows>(plan, stage)),
        count_(plan.point_count),
        misfits_(misfits) {}
  void match(const double* nets, const FitRound&) override {
    double furthest = 0.0;
    constexpr double roof = 1130.0;  // mm, the least height of it
    for (int k = 0; k < count_; ++k)
      if (nets[3 * k + 2] > roof) furthest = std::max(furthest, nets[3 * k]);
    constexpr double between = 3800.0;  // the roof of the template ends at about 3300
    excess_ = furthest > between ? misfits_.estate : misfits_.saloon;
    term_->set({});
  }
  model::WeightedNetTerm term() const override { return {term_, 1.0}; }
  double excess() const override { return excess_; }

 private:
  std::shared_ptr<NetRows> term_;
  int count_;
  Misfits misfits_;
  double excess_ = 0.0;
};

/// The start that wins without moving.
std::size_t winner(const std::vector<FitStart>& starts, JudgesRoofs::Misfits whole,
                   JudgesRoofs::Misfits closed) {
  FitOptions options;
  options.starts = starts;
  options.warp_rounds = options.curve_rounds = options.body_rounds = options.unfold_rounds = 0;
  const FitTargetMaker target = [=](const model::BodyPlan& plan, model::Stage stage, FitDetail) {
    return std::make_unique<JudgesRoofs>(plan, stage, stage == model::Stage::base ? whole : closed);
  };
  const model::Model fitted = fit_body({target}, start_model(), options).model;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const model::Model start = started(start_model(), starts[k]);
    double off = 0.0;
    for (std::size_t c = 0; c < start.curves.size(); ++c)
      for (std::size_t i = 0; i < start.curves[c].points.size(); ++i)
        off = std::max(off, (start.curves[c].points[i] - fitted.curves[c].points[i]).norm());
    if (off < 1e-6) return k;
  }
  return starts.size();
}

const FitStart saloon, second_saloon{{100.0, 0.0, 0.0}, 0.0}, estate{{0.0, 0.0, 0.0}, 1.0};

TEST(FitBody, TheClosestOfTheOtherKindGoesToTheEndToo) {
  const std::vector<FitStart> starts{saloon, second_saloon, estate};
  EXPECT_EQ(winner(starts, {1.0, 3.0}, {1.0, 0.1}), 2U);
  EXPECT_LT(winner(starts, {1.0, 3.0}, {0.1, 1.0}), 2U);
}

TEST(FitBody, OfTwoAsCloseThatWithTheLessBentPatchesWins) {
  const auto bending = [](const FitStart& start) {
    double sum = 0.0;
    for (const model::Surface& face :
         model::build(started(start_model(), start), model::Stage::base))
      sum += model::face_integrals(face).bending;
    return sum;
  };
  const bool estate_bends_more = bending(estate) > bending(saloon);
  for (const bool estate_first : {false, true}) {
    const std::vector<FitStart> starts =
        estate_first ? std::vector{estate, saloon} : std::vector{saloon, estate};
    const std::size_t won = winner(starts, {1.0, 1.0}, {1.0, 1.0});
    EXPECT_EQ(won == (estate_first ? 0U : 1U), !estate_bends_more);
  }
  // But much closer is better, whatever it bends.
  EXPECT_EQ(winner({saloon, estate}, {1.0, 1.0}, {0.2, 1.0}), 0U);
  EXPECT_EQ(winner({saloon, estate}, {1.0, 1.0}, {1.0, 0.2}), 1U);
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
  EXPECT_THAT(refusal([](FitOptions& o) { o.edges = -1.0; }), HasSubstr(" edges "));
  FitOptions options;
  options.rims = -1.0;
  EXPECT_THROW(fit_body({}, start_model(), options), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::optimize
