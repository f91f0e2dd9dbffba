// Fitting a body to points of another one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <fstream>

#include "io/read_model.hpp"
#include "model/build.hpp"
#include "model/evaluator.hpp"
#include "model/selection.hpp"
#include "optimize/align_scan.hpp"
#include "optimize/deviation.hpp"
#include "optimize/fit_scan.hpp"
#include "optimize/folded_scan.hpp"
#include "optimize/net_rows.hpp"
#include "optimize/orient_normals.hpp"
#include "optimize/random_pose.hpp"
#include "optimize/simulate_scan.hpp"
#include "tests/optimize/scan_samples.hpp"

namespace bodyline::optimize {
namespace {

using testing::HasSubstr;

// A scanner's noise of 1 mm averages out over a face; what is left are places where curves slide.
constexpr double median_tolerance = 0.8, most_tolerance = 4.0;  // mm

model::Model start_model() { return io::read_model(BODYLINE_SOURCE_DIR "/cars/template.toml"); }

/// The template with its curves moved by up to 60 mm, smoothly, and other cuts, shapes and
/// fullness.
model::Model other_car(unsigned seed) {
  model::Model car = start_model();
  const model::BodyContext context(car);
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * double(random()) / double(std::mt19937::max());
  };
  double phase[6];
  for (double& p : phase) p = between(0.0, 6.28);
  const model::Selection all(context.map, context.map.select(std::vector<std::string>{"*"}));
  Eigen::VectorXd x = all.gather(context.parameters), parameters = context.parameters;
  for (int k = 0; k < all.size(); ++k) {
    const model::Variable& variable = context.map.variables()[all.variables()[k]];
    if (variable.kind == model::ParameterKind::curve) {
      const int parameter = variable.ties.front().parameter;
      const int coordinate = (parameter - context.plan.layout.point(0, 0)) % 3;
      const Eigen::Vector3d p = parameters.segment<3>(parameter - coordinate);
      const double beside = coordinate == 1 ? std::min(1.0, std::abs(p.y()) / 400.0) : 1.0;
      x[k] += 60.0 * beside * std::sin(p.x() / 900.0 + phase[coordinate]) *
              std::cos(p.z() / 500.0 + phase[3 + coordinate]);
    } else if (variable.kind == model::ParameterKind::cut) {
      x[k] = variable.lower < 0.5 ? between(0.03, 0.1) : between(0.9, 0.97);
    } else if (variable.kind == model::ParameterKind::shape) {
      x[k] += 0.3 * between(variable.lower - x[k], variable.upper - x[k]);
    } else if (variable.kind == model::ParameterKind::fullness) {
      x[k] = between(1.0, 1.8);
    }
  }
  all.scatter(x, parameters);
  model::set_parameters(car, context.plan.layout, parameters);
  return car;
}

SimulateOptions scanner() {
  SimulateOptions options;
  options.points = 40000;
  options.noise_mm = 1.0;
  options.outliers = 0.1;
  return options;
}

const ScanFitOptions quick{15000, 30000};

Distances from_truth(const model::Model& truth, const model::Model& fitted) {
  SimulateOptions clean;
  clean.points = 20000;
  clean.noise_mm = 0.0;
  clean.seed = 99;
  return measure_deviation(fitted, simulate_scan(truth, clean), {}).distances;
}

TEST(FitScan, RecoversAnotherCarFromNoisePointsAndOutliers) {
  const model::Model truth = other_car(1);
  const FitResult result = fit_scan(simulate_scan(truth, scanner()), {}, start_model(), {}, quick);
  const Distances before = from_truth(truth, start_model()),
                  after = from_truth(truth, result.model);
  EXPECT_GT(before.median, 5.0);
  EXPECT_LE(after.median, median_tolerance);
  EXPECT_LE(after.p99, most_tolerance);
  EXPECT_TRUE(result.folded_faces.empty());
}

// The whole way that a scan takes: any pose and unit, normals unknown.
TEST(FitScan, RecoversAnotherCarFromAnUnknownPoseAndUnit) {
  const model::Model truth = other_car(6);
  SimulateOptions options = scanner();
  options.points = 60000;
  options.pose = random_pose(6);
  model::Scan scan = simulate_scan(truth, options);
  scan.normals.clear();
  const AlignResult aligned = align_scan(scan, start_model());
  EXPECT_NEAR(aligned.pose.scale / options.pose.scale, 1.0, 1e-12);
  const model::Scan oriented = oriented_scan(scan, aligned.pose, start_model(), 60000);
  const FitResult result = fit_scan(oriented, aligned.pose, start_model(), {});
  // Clean points of the true car, where the scan's pose puts them.
  SimulateOptions clean;
  clean.points = 20000;
  clean.noise_mm = 0.0;
  clean.seed = 99;
  clean.pose = options.pose;
  const Distances after =
      measure_deviation(result.model, simulate_scan(truth, clean), aligned.pose).distances;
  EXPECT_LE(after.median, median_tolerance);
  EXPECT_LE(after.p99, most_tolerance);
  EXPECT_TRUE(result.folded_faces.empty());
}

TEST(FitStart, AnEstateKeepsItsLengthAndItsLowerBody) {
  const model::Model saloon = start_model();
  const model::Model estate = started(saloon, {Eigen::Vector3d::Zero(), 1.0});
  double furthest = 0.0;
  for (std::size_t c = 0; c < saloon.curves.size(); ++c) {
    for (std::size_t k = 0; k < saloon.curves[c].points.size(); ++k) {
      const Eigen::Vector3d &from = saloon.curves[c].points[k], &to = estate.curves[c].points[k];
      EXPECT_EQ(from.y(), to.y());
      EXPECT_EQ(from.z(), to.z());
      EXPECT_GE(to.x(), from.x());
      if (from.z() < 500.0) {
        EXPECT_EQ(from.x(), to.x());
      }
      furthest = std::max(furthest, to.x() - from.x());
    }
  }
  EXPECT_GT(furthest, 500.0);  // the rear edge of the roof
  for (const model::Surface& face : model::build(estate, model::Stage::base))
    EXPECT_TRUE(face.net.front().allFinite());
}

TEST(FitStart, WithoutChangesIsTheModel) {
  const model::Model model = start_model(), same = started(model, {});
  for (std::size_t c = 0; c < model.curves.size(); ++c)
    EXPECT_EQ(model.curves[c].points, same.curves[c].points);
}

struct RealCar {
  const char* name;
  double p90;  // mm; a car with steps and pockets has more
};
void PrintTo(const RealCar& car, std::ostream* stream) { *stream << car.name; }

class FitRealCar : public testing::TestWithParam<RealCar> {};

// Body panels only: glass, lamps and trim have other shapes than a body.
model::Scan panels_of(const std::string& name, const model::Scan& scan) {
  std::ifstream classes(BODYLINE_SOURCE_DIR "/../shared/scans/" + name + "_points.class.u8",
                        std::ios::binary);
  model::Scan panels;
  for (std::size_t k = 0; k < scan.points.size(); ++k) {
    if (classes.get() != 0) continue;
    panels.points.push_back(scan.points[k]);
    panels.normals.push_back(scan.normals[k]);
  }
  return panels;
}

TEST_P(FitRealCar, MeetsItsPanelsWithoutFolds) {
  const std::string name = GetParam().name;
  if (!have_scan(name)) GTEST_SKIP() << "no ../shared/scans here";
  const model::Scan scan = read_test_scan(name);
  const model::Model start = start_model();
  const AlignResult aligned = align_scan(scan, start);
  const FitResult result = fit_scan(scan, aligned.pose, start, {});
  const Distances panels =
      measure_deviation(result.model, panels_of(name, scan), aligned.pose).distances;
  constexpr double median = 2.0;
  EXPECT_LE(panels.median, median);
  EXPECT_LE(panels.p90, GetParam().p90);
  EXPECT_TRUE(result.folded_faces.empty());
}

INSTANTIATE_TEST_SUITE_P(Cars, FitRealCar,
                         testing::Values(RealCar{"mondeo", 8.0}, RealCar{"sedan", 8.0},
                                         RealCar{"escape", 12.0}, RealCar{"boxer", 8.0}),
                         [](const auto& car) { return std::string(car.param.name); });

TEST(FitScan, NeedsOneSideOnly) {
  const model::Model truth = other_car(2);
  SimulateOptions one_side = scanner();
  one_side.missing = Missing::left;
  const FitResult result = fit_scan(simulate_scan(truth, one_side), {}, start_model(), {}, quick);
  const Distances after = from_truth(truth, result.model);
  EXPECT_LE(after.median, 2.0 * median_tolerance);
  EXPECT_LE(after.p99, 2.0 * most_tolerance);
}

TEST(FitScan, HasTheSameBitsForAnyNumberOfThreads) {
  const model::Scan scan = simulate_scan(other_car(3), scanner());
  FitOptions options;
  options.warp_rounds = options.curve_rounds = options.body_rounds = 2;
  options.unfold_rounds = 0;
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const model::Model fitted = fit_scan(scan, {}, start_model(), options, {5000, 5000}).model;
    return model::to_parameters(fitted, model::ParameterLayout(fitted));
  };
  const Eigen::VectorXd one = with_threads(1);
  EXPECT_EQ(one, with_threads(2));
  EXPECT_EQ(one, with_threads(5));
}

TEST(FitScan, StopsWhenAskedWithABodyThatCanBeBuilt) {
  const model::Scan scan = simulate_scan(other_car(4), scanner());
  FitOptions options;
  std::atomic<int> rounds = 0;
  options.on_progress = [&](const FitProgress&) { ++rounds; };
  options.should_stop = [&] { return rounds >= 3; };
  const FitResult result = fit_scan(scan, {}, start_model(), options, quick);
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_EQ(rounds, 3);
  EXPECT_NO_THROW(model::build(result.model, model::Stage::body));
}

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

TEST(FoldedScan, RefusesPointsThatAreNotFinite) {
  model::Scan scan;
  scan.points = {{0, 0, 0}, {0, NAN, 0}};
  EXPECT_THROW(folded_scan(scan, {}, 2), std::invalid_argument);
}

TEST(FoldedScan, TellsWhichPointsItMirrored) {
  const FoldedScan folded = folded_scan({{{1, 2, 3}, {1, -2, 3}, {1, 0, 3}}, {}}, {}, 3);
  EXPECT_EQ(folded.mirrored, (std::vector<char>{1, 0, 0}));
  for (const Eigen::Vector3d& point : folded.scan.points) EXPECT_LE(point.y(), 0.0);
}

TEST(OrientedScan, HasUnitNormalsAlsoWhereTheFileHasNone) {
  model::Scan scan = simulate_scan(start_model(), scanner());
  for (std::size_t k = 0; k < scan.normals.size(); k += 7) {
    if (k % 2 == 0)
      scan.normals[k].setZero();
    else
      scan.normals[k].setConstant(NAN);
  }
  const model::Scan oriented = oriented_scan(scan, {}, start_model(), 5000);
  for (const Eigen::Vector3d& normal : oriented.normals) EXPECT_NEAR(normal.norm(), 1.0, 1e-12);
}

TEST(OrientedScan, TurnsNormalsOutwardHoweverTheyStand) {
  SimulateOptions options = scanner();
  options.outliers = 0.0;
  options.points = 5000;
  const model::Scan outward = simulate_scan(start_model(), options);
  const auto expect_outward = [&](const model::Scan& given) {
    const model::Scan oriented = oriented_scan(given, {}, start_model(), options.points);
    std::size_t alike = 0;
    for (std::size_t k = 0; k < oriented.normals.size(); ++k)
      alike += oriented.normals[k].dot(outward.normals[k]) > 0.0;
    // Of points beside the joints, where the whole patch is turned otherwise than the body.
    EXPECT_GT(alike, 99 * oriented.normals.size() / 100);
  };
  model::Scan given = outward;
  expect_outward(given);
  for (Eigen::Vector3d& normal : given.normals) normal *= -1.0;
  expect_outward(given);
  for (std::size_t k = 0; k < given.normals.size(); k += 2) given.normals[k] *= -1.0;
  expect_outward(given);
  given.normals.clear();
  expect_outward(given);
}

TEST(FitScan, RefusesAScanWithoutPointsOrNormals) {
  EXPECT_THROW(fit_scan({}, {}, start_model(), {}), std::invalid_argument);
  model::Scan scan = simulate_scan(start_model(), scanner());
  scan.normals.clear();
  EXPECT_THROW(fit_scan(scan, {}, start_model(), {}), std::invalid_argument);
}

TEST(Deviation, IsNothingForTheBodysOwnPoints) {
  SimulateOptions clean;
  clean.points = 5000;
  clean.noise_mm = 0.0;
  const model::Model car = other_car(5);
  const Distances distances = measure_deviation(car, simulate_scan(car, clean), {}).distances;
  // A point near the rim of a small face may have a nearer one on the next.
  EXPECT_LE(distances.p99, 1e-3);
}

TEST(Deviation, TellsTheSideOfThePoints) {
  const model::Model car = start_model();
  SimulateOptions clean;
  clean.points = 5000;
  clean.noise_mm = 0.0;
  model::Scan scan = simulate_scan(car, clean);
  for (std::size_t k = 0; k < scan.points.size(); ++k) scan.points[k] += 2.0 * scan.normals[k];
  double sum = 0.0;
  const Deviation deviation = measure_deviation(car, scan, {});
  for (const FaceDeviation& face : deviation.faces) sum += face.mean * double(face.points);
  EXPECT_NEAR(sum / double(deviation.matches.size()), 2.0, 0.1);
}

TEST(Deviation, NamesPatchesWithoutPoints) {
  SimulateOptions clean;
  clean.points = 20000;
  clean.noise_mm = 0.0;
  model::Scan scan = simulate_scan(start_model(), clean), cut;
  for (std::size_t k = 0; k < scan.points.size(); ++k) {
    if (scan.points[k].z() > 700.0) continue;  // the cabin
    cut.points.push_back(scan.points[k]);
    cut.normals.push_back(scan.normals[k]);
  }
  const auto unseen = measure_deviation(start_model(), cut, {}).unseen_patches;
  EXPECT_NE(std::find(unseen.begin(), unseen.end(), "roof"), unseen.end());
  EXPECT_EQ(std::find(unseen.begin(), unseen.end(), "door_lower"), unseen.end());
  EXPECT_TRUE(measure_deviation(start_model(), scan, {}).unseen_patches.empty());
}

}  // namespace
}  // namespace bodyline::optimize
