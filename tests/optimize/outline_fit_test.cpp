// Fitting a body to outlines alone, and to outlines beside other targets.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "model/build.hpp"
#include "model/measures.hpp"
#include "optimize/deviation.hpp"
#include "optimize/fit_scan.hpp"
#include "optimize/outline_deviation.hpp"
#include "optimize/outline_fit_target.hpp"
#include "optimize/simulate_scan.hpp"
#include "optimize/strain_target.hpp"
#include "outline_support.hpp"
#include "scan_samples.hpp"

namespace bodyline::optimize {
namespace {

using model::Stage;
using model::View;

constexpr double met = 1.0;     // mm, what outlines are to be met to
constexpr double held = 100.0;  // weight of the strain, as the program has it

FitOptions outline_options() {
  FitOptions options;
  options.starts = {FitStart{}};
  return options;
}

FitResult fit_outlines(const std::vector<model::PlacedDrawing>& drawings, const model::Model& start,
                       const FitOptions& options = outline_options()) {
  return fit_body({outline_fit_target(drawings), strain_target(held)}, start, options);
}

double bending(const model::Model& car, Stage stage) {
  double sum = 0.0;
  for (const model::Surface& face : model::build(car, stage))
    sum += model::face_integrals(face).bending;
  return sum;
}

Distances from_truth(const model::Model& truth, const model::Model& fitted) {
  SimulateOptions clean;
  clean.points = 20000;
  clean.noise_mm = 0.0;
  return measure_deviation(fitted, simulate_scan(truth, clean), {}).distances;
}

TEST(OutlineFit, MeetsAllOutlinesOfAnotherCarWithAFairBody) {
  const model::Model truth = outline_test_car("model1"), start = outline_test_car("template");
  const auto drawings = traced_outlines(truth, model::all_views());
  const FitResult result = fit_outlines(drawings, start);
  for (const Stage stage : {Stage::base, Stage::body}) {
    const auto before = measure_outlines(start, drawings, stage);
    const auto after = measure_outlines(result.model, drawings, stage);
    for (std::size_t k = 0; k < after.size(); ++k) {
      EXPECT_GT(before[k].median, 3.0 * met);
      EXPECT_LE(after[k].median, met) << model::view_name(after[k].view);
    }
  }
  EXPECT_TRUE(result.folded_faces.empty());
  // As fair as the start, whose transitions are sharp; model 1 itself has 4600.
  EXPECT_LE(bending(result.model, Stage::body), bending(start, Stage::body));
  EXPECT_LE(bending(result.model, Stage::base), 10.0 * bending(start, Stage::base));
  const Distances before = from_truth(truth, start), after = from_truth(truth, result.model);
  EXPECT_LE(after.median, 0.5 * before.median);
}

TEST(OutlineFit, KeepsAnOutlineThatIsDrawnInPartOnly) {
  // The roof line alone, from the hood to the trunk: an open line.
  const model::Model truth = outline_test_car("model2");
  auto drawings = traced_outlines(truth, {View::side});
  std::vector<Eigen::Vector2d> roof;
  for (const model::CubicSegment& segment : drawings.front().paths.front().segments) {
    if (segment.points[0].y() > 700.0) roof.push_back(segment.points[0]);
  }
  std::sort(roof.begin(), roof.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  drawings.front().paths = {straight_path(roof)};
  const FitResult result = fit_outlines(drawings, outline_test_car("template"));
  EXPECT_LE(measure_outlines(result.model, drawings).front().median, met);
  EXPECT_TRUE(result.folded_faces.empty());
  // Nothing says how long the car is: the rear end moves with the whole only.
  const auto size = [](const model::Model& car) {
    return model::bounding_box(model::build(car, Stage::body), model::Halves::both).size();
  };
  EXPECT_NEAR(size(result.model).x(), size(outline_test_car("template")).x(), 400.0);
}

TEST(OutlineFit, HasTheSameBitsForAnyNumberOfThreads) {
  const auto drawings = traced_outlines(outline_test_car("model2"), model::all_views());
  FitOptions options = outline_options();
  options.warp_rounds = options.curve_rounds = options.body_rounds = 2;
  options.unfold_rounds = 0;
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const model::Model fitted = fit_outlines(drawings, outline_test_car("template"), options).model;
    return model::to_parameters(fitted, model::ParameterLayout(fitted));
  };
  const Eigen::VectorXd one = with_threads(1);
  EXPECT_EQ(one, with_threads(2));
  EXPECT_EQ(one, with_threads(4));
}

TEST(OutlineFit, NeedsAnOutline) { EXPECT_THROW(outline_fit_target({}), std::invalid_argument); }

TEST(OutlineFit, OfARealCarMeetsItsOutlinesAndComesNearItsScan) {
  if (!have_mesh("sedan")) GTEST_SKIP() << "../shared/scans is not there";
  std::vector<model::PlacedDrawing> drawings;
  for (const View view : model::all_views()) drawings.push_back(mask_outline("sedan", view));
  const FitResult result = fit_outlines(drawings, outline_test_car("template"));
  for (const OutlineDeviation& view : measure_outlines(result.model, drawings)) {
    EXPECT_LE(view.median, met) << model::view_name(view.view);
    RecordProperty("outline_" + model::view_name(view.view), std::to_string(view.median));
  }
  EXPECT_TRUE(result.folded_faces.empty());
  // What lies between outlines is held by the start's shape: some mm off, not some cm.
  const Deviation deviation = measure_deviation(result.model, read_test_scan("sedan"), {});
  RecordProperty("scan_median", std::to_string(deviation.distances.median));
  EXPECT_LE(deviation.distances.median, 15.0);
}

}  // namespace
}  // namespace bodyline::optimize
