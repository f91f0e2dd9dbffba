// Dimensions and hard points that a fit must keep.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/read_model.hpp"
#include "model/evaluator.hpp"
#include "optimize/bounded_target.hpp"
#include "optimize/dimension_target.hpp"
#include "optimize/fit_body.hpp"
#include "optimize/fit_phase.hpp"
#include "optimize/hard_point_target.hpp"
#include "optimize/net_rows.hpp"
#include "optimize/scan_fit_target.hpp"
#include "optimize/scan_match.hpp"
#include "optimize/simulate_scan.hpp"

namespace bodyline::optimize {
namespace {

constexpr double held_mm = 0.5;  // what the last round leaves over, far below a scan's own distance

model::Model read_car(const std::string& name) {
  return io::read_model(BODYLINE_SOURCE_DIR "/cars/" + name + ".toml");
}

model::Scan scan_of(const model::Model& car) {
  SimulateOptions scanner;
  scanner.points = 8000;
  scanner.noise_mm = 1.0;
  return simulate_scan(car, scanner);
}

const ScanFitOptions few_points{4000, 4000};

FitOptions short_fit() {
  FitOptions options;
  options.warp_rounds = options.curve_rounds = 5;
  options.body_rounds = 12;
  options.unfold_rounds = 0;
  return options;
}

double measured(const model::Model& car, const std::string& name) {
  const auto context = std::make_shared<model::BodyContext>(car);
  model::EvaluatorOptions options;
  options.stage = model::Stage::body;
  model::Evaluator evaluator(context, {}, options);
  evaluator.build(Eigen::VectorXd(0));
  const model::DimensionMeter meter(car, context->plan, options.stage);
  return meter.measure(model::dimension_of(car, name), evaluator.nets()).value;
}

// The signed distance of a point from a body, outside positive.
double distance_from(const model::Model& car, const Eigen::Vector3d& point) {
  const auto context = std::make_shared<model::BodyContext>(car);
  model::EvaluatorOptions options;
  options.stage = model::Stage::body;
  model::Evaluator evaluator(context, {}, options);
  evaluator.build(Eigen::VectorXd(0));
  model::Scan scan;
  scan.points = {point};
  return ScanMatcher(context->plan, options.stage, scan).match(evaluator.nets()).front().distance;
}

TEST(DimensionTarget, HoldsWhatTheScanWouldHaveOtherwise) {
  const model::Model start = read_car("template"), truth = read_car("model2");
  const model::Scan scan = scan_of(truth);
  const double length = measured(truth, "length") + 25.0, rake = measured(truth, "rake.windshield");
  const auto fitted = fit_body(
      {scan_fit_target(scan, {}, few_points),
       dimension_target(start,
                        {{"length", length, length}, {"rake.windshield", rake + 1.0, rake + 5.0}})},
      start, short_fit());
  EXPECT_NEAR(measured(fitted.model, "length"), length, held_mm);
  EXPECT_GT(measured(fitted.model, "rake.windshield"), rake + 0.9);
}

TEST(DimensionTarget, ABoundThatHoldsAnywayChangesNothing) {
  const model::Model start = read_car("template"), truth = read_car("model2");
  const model::Scan scan = scan_of(truth);
  const auto with = fit_body(
      {scan_fit_target(scan, {}, few_points), dimension_target(start, {{"height", 100.0, 9000.0}})},
      start, short_fit());
  const auto without = fit_body({scan_fit_target(scan, {}, few_points)}, start, short_fit());
  for (std::size_t c = 0; c < with.model.curves.size(); ++c)
    EXPECT_EQ(with.model.curves[c].points, without.model.curves[c].points);
}

/// One quantity, the first number of the nets, that should be at least 1; or none at all.
class FirstNumber : public BoundedTarget {
 public:
  FirstNumber(const model::BodyPlan& plan, double factor)
      : BoundedTarget(plan, model::Stage::base), factor_(factor) {}

 private:
  std::vector<NetRow> measure(const double*) override {
    NetRow row;
    row.slopes = {{0, factor_}};
    row.lower = 1.0;
    return {row};
  }
  double factor_;
};

class BoundedTargetLaws : public testing::Test {
 protected:
  double value(FirstNumber& target) {
    return target.term().term->value(nets_.data(), 1.0, nullptr);
  }
  model::BodyContext context_{read_car("template")};
  std::vector<double> nets_ = std::vector<double>(3 * context_.plan.point_count, 0.0);
};

TEST_F(BoundedTargetLaws, MatchingChangesNothingHoweverOften) {
  FirstNumber target(context_.plan, 1.0);
  for (int k = 0; k < 3; ++k) {
    target.match(nets_.data(), {});
    EXPECT_EQ(value(target), 1.0);
    EXPECT_EQ(target.excess(), 1.0);
  }
}

TEST_F(BoundedTargetLaws, WhatARoundLeavesOverAddsUp) {
  FirstNumber target(context_.plan, 1.0);
  for (const double left_over : {2.0, 3.0, 4.0}) {
    target.match(nets_.data(), {});
    target.advance();
    EXPECT_EQ(value(target), left_over * left_over);
  }
}

TEST_F(BoundedTargetLaws, AnExcessThatIsNoNumberIsNotHidden) {
  FirstNumber target(context_.plan, std::numeric_limits<double>::infinity());
  target.match(nets_.data(), {});  // 0 times infinity
  target.advance();
  EXPECT_TRUE(std::isnan(target.excess()));
}

TEST(FitPhase, AskingForTheMisfitChangesNoRoundAfterIt) {
  const model::Model start = read_car("template");
  const model::Scan scan = scan_of(read_car("model2"));
  const double length = measured(start, "length") + 40.0;
  const std::vector<FitTargetMaker> targets{scan_fit_target(scan, {}, few_points),
                                            dimension_target(start, {{"length", length, length}})};
  const auto after_rounds = [&](bool asks) {
    FitPhaseOptions options;
    options.stage = model::Stage::base;
    options.vary = {"curve.*"};
    options.evaluations = 15;
    FitPhase phase(start, targets, options);
    FitRound round;
    round.reach = {100.0, 100.0};
    for (const bool anew : {true, true}) {
      round.search_anew = anew;
      phase.run(round);
      if (asks) phase.misfit(round);
    }
    const model::Model model = phase.model();
    return model::to_parameters(model, model::ParameterLayout(model));
  };
  EXPECT_EQ(after_rounds(true), after_rounds(false));
}

TEST(FitPhase, TheMisfitOfABodyIsTheSameWhenAskedAgain) {
  const model::Model start = read_car("template");
  const double length = measured(start, "length") + 40.0;
  FitPhaseOptions options;
  options.stage = model::Stage::base;
  options.vary = {"curve.*"};
  options.evaluations = 5;
  FitPhase phase(start,
                 {scan_fit_target(scan_of(read_car("model2")), {}, few_points),
                  dimension_target(start, {{"length", length, length}})},
                 options);
  FitRound round;
  round.reach = {100.0, 100.0};
  phase.run(round);
  const double misfit = phase.misfit(round);
  EXPECT_EQ(phase.misfit(round), misfit);
  EXPECT_GT(misfit, 0.0);
}

std::string refusal(const DimensionBound& bound) {
  try {
    dimension_target(read_car("template"), {bound});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(DimensionTarget, RefusesWhatNoCarHasAndNamesWhatCanBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {-5.0, 0.0, 4.7, 1e9, 1e300, -HUGE_VAL, HUGE_VAL, nan}) {
    const std::string allowed = "length is from 100 to 20000 mm, not ";
    EXPECT_TRUE(refusal({"length", value, value}).starts_with(allowed)) << value;
  }
  for (const double value : {HUGE_VAL, nan}) {
    EXPECT_NE(refusal({"length", 4000.0, value}), "") << value;
    EXPECT_NE(refusal({"length", -value, 4000.0}), "") << value;
  }
  EXPECT_EQ(refusal({"length", 0.0, 50.0}), "length is from 100 to 20000 mm, not 0 to 50");
  EXPECT_EQ(refusal({"length", 30000.0, 40000.0}),
            "length is from 100 to 20000 mm, not 30000 to 40000");
  EXPECT_EQ(refusal({"rake.windshield", 200.0, 200.0}),
            "rake.windshield is from 0 to 90 degrees, not 200");
  EXPECT_EQ(refusal({"rake.windshield", 0.0, 90.0}), "");
  EXPECT_EQ(refusal({"front_overhang", -200.0, 900.0}), "");
}

TEST(DimensionTarget, TakesAnIntervalThatIsPossibleInPart) {
  EXPECT_EQ(refusal({"length", 0.0, 4500.0}), "");
  EXPECT_EQ(refusal({"height", 0.0, 1500.0}), "");
  EXPECT_EQ(refusal({"length", 4000.0, 1e9}), "");
  EXPECT_EQ(refusal({"rake.windshield", -5.0, 30.0}), "");
}

TEST(DimensionBounds, OfOneDimensionBecomeWhatAllOfThemAllow) {
  const auto both =
      merged({{"length", 4000.0, 4700.0}, {"width", 1.0, 2.0}, {"length", 4600, 5000}});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].name, "length");
  EXPECT_EQ(both[0].lower, 4600.0);
  EXPECT_EQ(both[0].upper, 4700.0);
  EXPECT_EQ(merged({{"length", 4600, 4600}, {"length", 4600, 4600}}).size(), 1u);
  EXPECT_THROW(merged({{"length", 4600, 4600}, {"length", 4601, 4700}}), std::invalid_argument);
}

TEST(DimensionTarget, RefusesBoundsInTheWrongOrder) {
  EXPECT_THROW(dimension_target(read_car("template"), {{"length", 2.0, 1.0}}),
               std::invalid_argument);
}

TEST(HardPointTarget, TheSurfacePassesThroughAndKeepsClear) {
  const model::Model start = read_car("template"), truth = read_car("model2");
  const model::Scan scan = scan_of(truth);
  // Of the car's own roof, hood and side: one to pass through, one to contain, one to keep out.
  Eigen::Vector3d high = scan.points.front(), side = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : scan.points) {
    if (point.z() > high.z()) high = point;
    // Away from the sill, where the surface turns back under the car.
    const bool on_door = point.z() > 550.0 && std::abs(point.x() - 2200.0) < 400.0;
    if (on_door && point.y() < side.y()) side = point;
  }
  const std::vector<model::HardPoint> points{
      {high + Eigen::Vector3d(0, 0, 8), model::HardPointRule::through},
      {high + Eigen::Vector3d(-500, 0, -5), model::HardPointRule::inside, 20.0},
      {side + Eigen::Vector3d(0, 3, 0), model::HardPointRule::outside, 10.0}};
  const auto fitted = fit_body({scan_fit_target(scan, {}, few_points), hard_point_target(points)},
                               start, short_fit());
  EXPECT_NEAR(distance_from(fitted.model, points[0].point), 0.0, held_mm);
  EXPECT_LT(distance_from(fitted.model, points[1].point), -20.0 + held_mm);
  EXPECT_GT(distance_from(fitted.model, points[2].point), 10.0 - held_mm);
}

TEST(HardPointTarget, RefusesWhatIsNoPointOrNoMargin) {
  EXPECT_THROW(hard_point_target({{{NAN, 0, 0}}}), std::invalid_argument);
  EXPECT_THROW(hard_point_target({{{0, -1e300, 0}}}), std::invalid_argument);
  EXPECT_THROW(hard_point_target({{{0, 0, 0}, model::HardPointRule::inside, 1e300}}),
               std::invalid_argument);
  EXPECT_THROW(hard_point_target({{{0, 0, 0}, model::HardPointRule::inside, -1.0}}),
               std::invalid_argument);
}

// value, adjoint and residual form of rows above, below and inside of their bounds.
TEST(NetRows, FormsAgree) {
  const auto context = std::make_shared<model::BodyContext>(read_car("template"));
  NetRows rows(context->plan, model::Stage::base);
  rows.set({{{{0, 2.0}, {4, -1.0}}, 1.0, -5.0, 0.5},
            {{{1, 1.0}}, 0.0, 7.0, 9.0},
            {{{2, 3.0}}, 0.0, -100.0, 100.0}});
  std::vector<double> nets(3 * context->plan.point_count, 0.0);
  nets[0] = 1.5, nets[1] = 2.0, nets[2] = 1.0, nets[4] = 0.25;
  Eigen::VectorXd r(rows.residual_count());
  model::NetTerm::Jacobian jacobian;
  rows.residuals(nets.data(), r, &jacobian);
  EXPECT_EQ(r, Eigen::Vector3d(3.25, -5.0, 0.0));
  std::vector<double> bar(nets.size(), 0.0);
  EXPECT_DOUBLE_EQ(rows.value(nets.data(), 0.5, bar.data()), r.squaredNorm());
  const Eigen::VectorXd expected = jacobian.transpose() * r;
  EXPECT_EQ(Eigen::Map<Eigen::VectorXd>(bar.data(), Eigen::Index(bar.size())), expected);
}

}  // namespace
}  // namespace bodyline::optimize
