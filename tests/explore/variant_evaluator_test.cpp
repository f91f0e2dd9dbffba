#include "explore/variant_evaluator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include "io/write_scan.hpp"
#include "model/build.hpp"
#include "model/check_body.hpp"
#include "model/connect.hpp"
#include "model/dimension.hpp"
#include "model/evaluator.hpp"
#include "model/parameters.hpp"
#include "model/silhouette.hpp"
#include "model/silhouette_outline.hpp"
#include "optimize/deviation.hpp"
#include "optimize/simulate_scan.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::Study;
using explore::VariantEvaluator;
using explore::VariantOutcome;
using explore::VariantPlan;
using explore::VariantStatus;

const std::string family = "blend = [\"template.toml\", \"model1.toml\", \"model2.toml\"]";
const std::string everything = R"(
bending = {}
variation = {}
area = {}
fold = {}
closeness = {}
hood_bending = { kind = "bending", faces = ["hood", "roof"], stage = "base" }
length = {}
width = {}
height = {}
wheelbase = {}
front_overhang = {}
rear_overhang = {}
rake = { face = "windshield" }
frontal_area = {}
volume = {}
folds = {}
kink = {}
gap = {}
)";

using Metrics = std::map<std::string, double>;

Metrics named(const Study& study, const std::vector<double>& values) {
  Metrics metrics;
  for (std::size_t k = 0; k < values.size(); ++k) metrics[study.metrics[k].name] = values[k];
  return metrics;
}

// Variants between the three cars with everything that can be measured.
class Measured : public ::testing::Test {
 protected:
  static constexpr int count = 6;
  const Study study =
      study_of(study_text(family, "points = { vary = [\"curve.*\"], offset = [-3, 3] }", everything,
                          "kind = \"sobol\"\ncount = " + std::to_string(count)));
  const std::shared_ptr<const VariantPlan> plan = std::make_shared<VariantPlan>(study);
  VariantEvaluator evaluator{plan};

  Metrics measure(const std::vector<double>& values) {
    std::vector<double> metrics(study.metrics.size());
    outcome = evaluator.measure(values, metrics);
    return named(study, metrics);
  }
  template <class Compare>
  void for_each_variant(const Compare& compare) {
    for (const auto& values : variants(study, plan->space, count))
      compare(measure(values), plan->space.variant(values, "variant"));
  }
  VariantOutcome outcome;
};

TEST_F(Measured, SizesAreThoseOfTheCheck) {
  constexpr double each_end = 2e-6;  // mm; the check finds an end to 1e-6
  for_each_variant([&](const Metrics& metrics, const model::Model& model) {
    const model::BodyTotals totals = model::check_body(model).totals;
    EXPECT_NEAR(metrics.at("length"), totals.box.size().x(), each_end);
    EXPECT_NEAR(metrics.at("width"), totals.box.size().y(), each_end);
    EXPECT_NEAR(metrics.at("height"), totals.box.size().z(), each_end);
    EXPECT_NEAR(metrics.at("wheelbase"), *totals.wheelbase_mm, 1e-7);
    // The pillar feet are no polynomials: their integrals have an error of their own.
    EXPECT_NEAR(metrics.at("volume"), *totals.volume_mm3 / 1e9, 1e-8);
    EXPECT_NEAR(metrics.at("area"), totals.area_mm2 / 1e6, 1e-4);
  });
}

TEST_F(Measured, DimensionsAreThoseOfTheMeter) {
  for_each_variant([&](const Metrics& metrics, const model::Model& model) {
    const model::BodyContext context(model);
    const model::DimensionMeter meter(model, context.plan, model::Stage::body);
    const auto value = [&](const std::string& name) {
      return meter.measure(model::dimension_of(model, name), evaluator.nets().data()).value;
    };
    for (const std::string name : {"front_overhang", "rear_overhang"})
      EXPECT_NEAR(metrics.at(name), value(name), 2e-6);
    EXPECT_NEAR(metrics.at("rake"), value("rake.windshield"), 1e-10);
  });
}

TEST_F(Measured, EnergiesAreThoseOfTheModelItself) {
  for_each_variant([&](const Metrics& metrics, const model::Model& model) {
    const auto context = std::make_shared<const model::BodyContext>(model);
    model::EvaluatorOptions options;
    options.terms = {{model::TermKind::bending, 1.0, model::Stage::body, {}},
                     {model::TermKind::variation, 1.0, model::Stage::body, {}},
                     {model::TermKind::fold, 1.0, model::Stage::body, {}},
                     {model::TermKind::bending, 1.0, model::Stage::base, {"hood", "roof"}}};
    model::Evaluator direct(context, {}, options);
    direct.evaluate(Eigen::VectorXd(0), nullptr);
    const std::vector<double>& terms = direct.term_values();
    const auto near = [&](const std::string& name, double value) {
      EXPECT_NEAR(metrics.at(name), value, 1e-12 * (1.0 + value)) << name;  // the order of sums
    };
    near("bending", terms[0]);
    near("variation", terms[1]);
    near("fold", terms[2]);
    near("hood_bending", terms[3]);
  });
}

TEST_F(Measured, EdgesAreThoseOfTheCheck) {
  for_each_variant([&](const Metrics& metrics, const model::Model& model) {
    model::BodyCheckOptions options;
    options.edge_samples = 17;
    double gap = 0.0, kink = 0.0;
    for (const model::EdgeCheck& edge : model::check_body(model, options).edges) {
      if (edge.stage != model::Stage::body) continue;
      gap = std::max(gap, edge.deviation.gap_mm);
      kink = std::max(kink, edge.deviation.normal_deviation_deg);
    }
    EXPECT_NEAR(metrics.at("gap"), gap, 1e-10);
    EXPECT_NEAR(metrics.at("kink"), kink, 1e-7);
  });
}

// 64 normals of a face cannot see more folds than a close look.
TEST_F(Measured, FoldedFacesAreFoldedInTheCheckToo) {
  for_each_variant([&](const Metrics& metrics, const model::Model& model) {
    int folded = 0;
    std::vector<std::string> names;
    for (const model::FaceCheck& face : model::check_body(model).faces) {
      if (face.stage != model::Stage::body || !face.fold.folded) continue;
      folded += face.mirrored ? 2 : 1;
      names.push_back(face.name);
    }
    EXPECT_LE(metrics.at("folds"), folded);
    if (metrics.at("folds") > 0) {
      EXPECT_EQ(outcome.status, VariantStatus::folded);
      EXPECT_THAT(names, ::testing::Contains(plan->causes[outcome.cause]));
    }
  });
  // Model 1 as printed has one.
  std::vector<double> as_printed = plan->space.start_values();
  as_printed[0] = 0.0;
  as_printed[1] = 1.0;
  EXPECT_EQ(measure(as_printed).at("folds"), 2.0);
  EXPECT_EQ(plan->causes[outcome.cause], "door_upper__door_lower");
}

TEST_F(Measured, ClosenessIsZeroAtTheFirstModelAlone) {
  EXPECT_EQ(measure(plan->space.start_values()).at("closeness"), 0.0);
  for_each_variant([&](const Metrics& metrics, const model::Model&) {
    EXPECT_GT(metrics.at("closeness"), 1.0);
  });
}

// Heights of a fine picture of the body seen from the front, its width taken at many points of
// every face: a lower bound, and close to it.
TEST_F(Measured, FrontalAreaIsThatOfTheOutline) {
  constexpr int samples = 120, heights = 400;
  const Metrics metrics = measure(plan->space.start_values());
  const auto faces =
      model::build(study.models.front().model, model::Stage::body, model::Halves::left_and_central);
  const model::Box box = model::bounding_box(faces, model::Halves::left_and_central);
  std::vector<double> half(heights, 0.0);
  for (const model::Surface& face : faces) {
    for (int i = 0; i <= samples; ++i) {
      for (int j = 0; j <= samples; ++j) {
        const Eigen::Vector3d p = jet(face, double(i) / samples, double(j) / samples, 0).d[0];
        const int row =
            std::min(heights - 1, int((p.z() - box.low.z()) / box.size().z() * heights));
        half[row] = std::max(half[row], std::abs(p.y()));
      }
    }
  }
  double area = 0.0;
  for (const double y : half) area += 2.0 * y * box.size().z() / heights / 1e6;
  EXPECT_NEAR(metrics.at("frontal_area"), area, 2e-3 * area);
}

TEST_F(Measured, DoNotDependOnWhatWasMeasuredBefore) {
  const auto list = variants(study, plan->space, count);
  std::vector<Metrics> forward;
  for (const auto& values : list) forward.push_back(measure(values));
  for (std::size_t k = list.size(); k-- > 0;) EXPECT_EQ(measure(list[k]), forward[k]);
}

TEST(VariantEvaluator, DistanceToAScanIsThatOfTheDeviation) {
  const Folder folder;
  const std::string file = (folder / "scan.ply").string();
  const Study base = small_study(1);
  optimize::SimulateOptions options;
  options.points = 3000;
  io::write_scan(optimize::simulate_scan(base.models.front().model, options), file);
  const Study study = study_of(study_text(
      "model = \"model1.toml\"",
      "roof = { vary = [\"curve.roof__side_window[1-4].z\"], offset = [-20, 20] }",
      "distance = { kind = \"scan\", file = \"" + file + "\", points = 3000, posed = true }",
      "kind = \"random\"\ncount = 3"));
  const auto plan = std::make_shared<VariantPlan>(study);
  VariantEvaluator evaluator(plan);
  std::vector<std::vector<double>> list = variants(study, plan->space, 3);
  for (const auto& values : list) {
    double distance = 0.0;
    evaluator.measure(values, {&distance, 1});
    const model::Model model = plan->space.variant(values, "variant");
    const optimize::Deviation deviation = optimize::measure_deviation(
        model, optimize::simulate_scan(base.models.front().model, options), {});
    // The scan went through a file of 32-bit numbers.
    EXPECT_NEAR(distance, deviation.distances.trimmed_rms, 1e-3);
  }
}

TEST(VariantEvaluator, MeasuresMoreThanOneVariation) {
  const std::string variables = "shape = { vary = [\"shape.hood.*\"], offset = [-0.1, 0.1] }";
  const std::string all = "all = { kind = \"variation\" }",
                    hood = "hood = { kind = \"variation\", faces = [\"hood\"], stage = \"kept\" }";
  const auto metrics_of = [&](const std::string& metrics) {
    const auto plan = std::make_shared<VariantPlan>(study_of(
        study_text("model = \"model1.toml\"", variables, metrics, "kind = \"random\"\ncount = 1")));
    std::vector<double> values(plan->study.metrics.size());
    VariantEvaluator(plan).measure(variants(plan->study, plan->space, 1).front(), values);
    return values;
  };
  const std::vector<double> both = metrics_of(all + "\nbending = {}\n" + hood);
  EXPECT_EQ(both[0], metrics_of(all)[0]);
  EXPECT_EQ(both[2], metrics_of(hood)[0]);
  EXPECT_NE(both[0], both[2]);
}

// A silhouette is traced to points about 10 mm apart and drawn by chords of 5 mm.
constexpr double drawn_exactness = 0.5;

TEST(VariantEvaluator, DistanceToOutlinesIsSmallForTheCarThatWasDrawnAndGrowsAwayFromIt) {
  const Folder folder;
  const Study base = small_study(1);
  std::string views;
  for (const model::View view : {model::View::side, model::View::front}) {
    const auto lines = model::silhouette_outline(
        model::silhouette(model::silhouette_body(base.models.front().model, model::Stage::body),
                          view),
        view);
    const std::string path = (folder / (model::view_name(view) + ".csv")).string();
    std::ofstream file(path);
    for (const auto& line : lines) {
      for (const Eigen::Vector2d& point : line) file << point.x() << "," << point.y() << "\n";
      file << "\n";
    }
    views += (views.empty() ? "" : ",") + model::view_name(view) + "=" + path + "@1";
  }
  const auto plan = std::make_shared<VariantPlan>(study_of(study_text(
      "model = \"model1.toml\"",
      "roof = { vary = [\"curve.roof__side_window*.z\", \"curve.windshield__roof*.z\"], offset = "
      "[0, 60], linked = true }",
      "outline = { views = \"" + views + "\" }", "kind = \"star\"", "[checks]\nfolds = false")));
  VariantEvaluator evaluator(plan);
  std::vector<double> distances;
  for (const double offset : {0.0, 20.0, 60.0}) {
    evaluator.measure(std::vector<double>{offset}, {&distances.emplace_back(), 1});
  }
  EXPECT_LT(distances[0], drawn_exactness);
  EXPECT_GT(distances[1], 2.0 * distances[0]);
  EXPECT_GT(distances[2], 2.0 * distances[1]);
}

TEST(VariantEvaluator, AConstraintMakesVariantsInfeasibleAndIsNamed) {
  const Study study = small_study(40, "[constraints]\nheight = { most = 1215 }");
  const auto plan = std::make_shared<VariantPlan>([&] {
    Study without = study;
    without.checks.folds = false;
    return without;
  }());
  VariantEvaluator evaluator(plan);
  int broken = 0;
  for (const auto& values : variants(study, plan->space, 40)) {
    std::vector<double> metrics(2);
    const VariantOutcome outcome = evaluator.measure(values, metrics);
    EXPECT_EQ(outcome.status == VariantStatus::infeasible, metrics[1] > 1215.0);
    if (outcome.status != VariantStatus::infeasible) continue;
    ++broken;
    EXPECT_EQ(plan->causes[outcome.cause], "height");
  }
  EXPECT_GT(broken, 0);
  EXPECT_LT(broken, 40);
}

TEST(VariantEvaluator, ABodyThatCannotBeBuiltHasNoMetrics) {
  const Study study = study_of(study_text(
      "model = \"model1.toml\"", "x = { vary = [\"fullness.hood__windshield.a\"], range = [2, 5] }",
      "bending = {}\nlength = {}", "kind = \"factorial\"\nlevels = 4", "[checks]\nfolds = false"));
  const auto plan = std::make_shared<VariantPlan>(study);
  VariantEvaluator evaluator(plan);
  const auto list = variants(study, plan->space, 4);
  std::vector<double> metrics(2);
  EXPECT_EQ(evaluator.measure(list[0], metrics).status, VariantStatus::valid);
  const VariantOutcome outcome = evaluator.measure(list[3], metrics);
  EXPECT_EQ(outcome.status, VariantStatus::fullness);
  EXPECT_EQ(plan->causes[outcome.cause], "hood__windshield");
  EXPECT_TRUE(std::isnan(metrics[0]));
  EXPECT_TRUE(std::isnan(metrics[1]));
  EXPECT_EQ(evaluator.measure(list[0], metrics).status, VariantStatus::valid);
}

}  // namespace
}  // namespace bodyline::testing
