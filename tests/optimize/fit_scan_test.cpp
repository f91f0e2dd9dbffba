// Fitting a body to points of another one.

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
#include "optimize/arch_gaps.hpp"
#include "optimize/deviation.hpp"
#include "optimize/fit_scan.hpp"
#include "optimize/orient_normals.hpp"
#include "optimize/random_pose.hpp"
#include "optimize/simulate_scan.hpp"
#include "tests/optimize/scan_samples.hpp"

namespace bodyline::optimize {
namespace {

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

TEST_P(FitRealCar, MeetsItsPanelsAndWheelArchesWithoutFolds) {
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
  constexpr double arch = 20.0;  // mm, of which some are how well the scan tells its end
  const auto gaps = arch_gaps(result.model, measure_deviation(result.model, scan, aligned.pose));
  EXPECT_EQ(gaps.size(), 6U);
  for (const ArchGap& gap : gaps)
    EXPECT_LE(std::abs(gap.gap), arch) << (gap.front ? "front " : "rear ") << gap.part;
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
