#include "explore/design_space.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "explore/philox.hpp"
#include "explore/study_error.hpp"
#include "model/parameters.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::ColumnKind;
using explore::DesignSpace;
using explore::Study;

const std::string model1 = "model = \"model1.toml\"";
const std::string blend = "blend = [\"template.toml\", \"model1.toml\", \"model2.toml\"]";
const std::string choice = "choice = [\"template.toml\", \"model1.toml\", \"model2.toml\"]";
const std::string random_sampler = "kind = \"random\"\ncount = 50";

// One group of each kind of range.
const std::string all_ranges = R"(
shape = { vary = ["shape.hood.*"], offset = [-0.1, 0.2] }
fullness = { vary = ["fullness.hood__windshield.*"], factor = [0.8, 1.1] }
cuts = { vary = ["cut.hood.*"], width = [0.02, 0.05] }
more = { vary = ["fullness.roof*"], range = [1.0, 1.5] }
bounded = { vary = ["cut.trunk_lid.*"] }
nose = { vary = ["curve.grille_bottom[0].x", "curve.grille_bottom[1].x"], offset = [-20, 30], linked = true, weights = [1, 0.5] }
tail = { vary = ["shape.tail.u*"], factor = [0.5, 2], linked = true }
)";

Study study_with(const std::string& base, const std::string& variables) {
  return study_of(study_text(base, variables, "bending = {}", random_sampler));
}

Eigen::VectorXd parameters_of(const model::Model& model) {
  return model::to_parameters(model, model::ParameterLayout(model));
}

int column_of(const DesignSpace& space, const std::string& name) {
  for (int k = 0; k < space.column_count(); ++k) {
    if (space.columns()[k].name == name) return k;
  }
  ADD_FAILURE() << name;
  return 0;
}

TEST(DesignSpace, StartsAtTheModelItself) {
  const Study study = study_with(model1, all_ranges);
  const DesignSpace space(study);
  const model::Model model = space.variant(space.start_values(), "start");
  EXPECT_EQ(parameters_of(model), parameters_of(study.models.front().model));
}

// Added to a coordinate of hundreds of mm, nothing is left of it.
TEST(DesignSpace, RefusesARangeThatVanishesInRounding) {
  try {
    const DesignSpace space(study_with(
        model1, "a = { vary = [\"curve.roof__side_window[1].z\"], offset = [1e-15, 2e-15] }"));
    FAIL() << "step " << space.columns().front().step;
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("it must be wider than rounding"));
  }
}

TEST(DesignSpace, RangesOfOneModelAreValuesOfItsVariables) {
  const DesignSpace space(study_with(model1, all_ranges));
  const auto column = [&](const std::string& name) {
    return space.columns()[column_of(space, name)];
  };
  const explore::Column shape = column("shape.hood.u[0]");
  EXPECT_EQ(shape.kind, ColumnKind::value);
  EXPECT_DOUBLE_EQ(shape.lower, shape.start - 0.1);
  EXPECT_DOUBLE_EQ(shape.upper, shape.start + 0.2);
  const explore::Column fullness = column("fullness.hood__windshield.a");
  EXPECT_DOUBLE_EQ(fullness.lower, 0.8 * fullness.start);
  EXPECT_DOUBLE_EQ(fullness.upper, 1.1 * fullness.start);
  EXPECT_EQ(column("cut.hood.u_lo").lower, 0.02);
  EXPECT_EQ(column("cut.hood.u_lo").upper, 0.05);
  EXPECT_EQ(column("cut.hood.u_hi").lower, 0.95);
  EXPECT_EQ(column("cut.hood.u_hi").upper, 0.98);
  EXPECT_EQ(column("cut.trunk_lid.u_lo").lower, model::VariableBounds{}.min_cut);
  EXPECT_EQ(column("nose").unit, "mm");
  EXPECT_EQ(column("nose").kind, ColumnKind::offset);
  EXPECT_EQ(column("tail").kind, ColumnKind::factor);
}

TEST(DesignSpace, ALinkMovesAllItsVariablesByTheirWeights) {
  const Study study = study_with(model1, all_ranges);
  const DesignSpace space(study);
  std::vector<double> values = space.start_values();
  values[column_of(space, "nose")] = 10.0;
  values[column_of(space, "tail")] = 1.5;
  const model::Model moved = space.variant(values, "moved");
  const model::Model& given = study.models.front().model;
  EXPECT_EQ(moved.curves[0].points[0].x(), given.curves[0].points[0].x() + 10.0);
  EXPECT_EQ(moved.curves[0].points[1].x(), given.curves[0].points[1].x() + 5.0);
  for (std::size_t p = 0; p < given.patches.size(); ++p) {
    const double factor = given.patches[p].name == "tail" ? 1.5 : 1.0;
    for (std::size_t k = 0; k < given.patches[p].shape_u.size(); ++k)
      EXPECT_EQ(moved.patches[p].shape_u[k], factor * given.patches[p].shape_u[k]);
  }
}

TEST(DesignSpace, ABlendReachesEachOfItsModelsExactly) {
  const Study study = study_with(blend, "");
  const DesignSpace space(study);
  EXPECT_EQ(space.dimension(), 2);
  for (std::size_t m = 0; m < 3; ++m) {
    std::vector<double> weights(3, 0.0);
    weights[m] = 1.0;
    EXPECT_EQ(parameters_of(space.variant(weights, "corner")),
              parameters_of(study.models[m].model));
  }
}

TEST(DesignSpace, ABlendIsTheWeightedMeanOfAllNumbers) {
  const Study study = study_with(blend, "");
  const DesignSpace space(study);
  const std::vector<double> weights{0.25, 0.25, 0.5};
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(space.context()->parameters.size());
  for (std::size_t m = 0; m < 3; ++m) mean += weights[m] * parameters_of(study.models[m].model);
  const Eigen::VectorXd blended = parameters_of(space.variant(weights, "mean"));
  EXPECT_LT((blended - mean).cwiseAbs().maxCoeff(), 1e-11);  // rounding of numbers of thousands
}

TEST(DesignSpace, WeightsOfABlendAreUniformOnTheirSimplexAndAddUpToOne) {
  const Study study =
      study_of(study_text(blend, "", "bending = {}", "kind = \"sobol\"\ncount = 4096"));
  const DesignSpace space(study);
  std::vector<double> mean(3, 0.0), square(3, 0.0);
  constexpr int count = 4096;
  for (const auto& weights : variants(study, space, count)) {
    EXPECT_EQ(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GE(weights[k], 0.0);
      mean[k] += weights[k] / count;
      square[k] += weights[k] * weights[k] / count;
    }
  }
  // Moments of the uniform distribution on a triangle; Sobol's points are that close to them.
  constexpr double sampling = 1e-3;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(mean[k], 1.0 / 3.0, sampling);
    EXPECT_NEAR(square[k], 1.0 / 6.0, sampling);
  }
}

TEST(DesignSpace, AChoiceTakesItsModelsEquallyOften) {
  const Study study =
      study_of(study_text(choice, "", "bending = {}", "kind = \"latin\"\ncount = 300"));
  const DesignSpace space(study);
  std::vector<int> taken(3, 0);
  for (const auto& values : variants(study, space, 300)) ++taken[std::size_t(values[0])];
  EXPECT_THAT(taken, ::testing::Each(100));
  EXPECT_EQ(parameters_of(space.variant(std::vector<double>{2.0}, "third")),
            parameters_of(study.models[2].model));
}

TEST(DesignSpace, RangesOfSeveralModelsAreAddedToThem) {
  const Study study =
      study_with(choice, "shape = { vary = [\"shape.hood.u[0]\"], offset = [-0.1, 0.2] }");
  const DesignSpace space(study);
  EXPECT_EQ(space.columns()[1].kind, ColumnKind::offset);
  const model::Model moved = space.variant(std::vector<double>{1.0, 0.125}, "moved");
  EXPECT_EQ(moved.patches[1].shape_u[0], study.models[1].model.patches[1].shape_u[0] + 0.125);
}

TEST(DesignSpace, PointsAndValuesAreInverse) {
  for (const std::string& base : {model1, blend, choice}) {
    const Study study = study_with(base, all_ranges);
    const DesignSpace space(study);
    for (const auto& values : variants(study, space, 50)) {
      std::vector<double> point(std::size_t(space.dimension())), again(values.size());
      space.point(values, point);
      space.values(point, again);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const explore::Column& column = space.columns()[k];
        // Two steps of 2^-31 of the range; of a weight, which takes a root, some more.
        EXPECT_NEAR(again[k], values[k], 1e-8 * (column.upper - column.lower)) << column.name;
      }
    }
  }
}

TEST(DesignSpace, CoordinatesReachBothEndsOfARange) {
  const DesignSpace space(study_with(model1, all_ranges));
  const std::size_t n = std::size_t(space.column_count());
  std::vector<double> low(n), high(n);
  space.values(std::vector<double>(n, 0.0), low);
  space.values(std::vector<double>(n, 1.0), high);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_EQ(low[k], space.columns()[k].lower);
    EXPECT_EQ(high[k], space.columns()[k].upper);
  }
}

// The body's variables are linear in each value: central differences with a long step are exact.
TEST(DesignSpace, ThePullbackIsTheDerivative) {
  constexpr double rounding = 1e-9;
  for (const std::string& base : {model1, blend, choice}) {
    const Study study = study_with(base, all_ranges);
    const DesignSpace space(study);
    const auto values = variants(study, space, 3)[2];
    Eigen::VectorXd x_bar(Eigen::Index(space.body_variables().size()));
    const explore::PlacedRandom random(3, 99);
    for (Eigen::Index k = 0; k < x_bar.size(); ++k)
      x_bar[k] = random.uniform(0, std::uint32_t(k))[0] - 0.5;
    std::vector<double> values_bar(values.size());
    space.body_pullback(values, x_bar, values_bar);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (space.columns()[k].kind == ColumnKind::choice) {
        EXPECT_EQ(values_bar[k], 0.0);
        continue;
      }
      std::vector<double> moved = values;
      Eigen::VectorXd above, below;
      moved[k] = values[k] + 0.5;
      space.body(moved, above);
      moved[k] = values[k] - 0.5;
      space.body(moved, below);
      const double expected = x_bar.dot(above - below);
      EXPECT_NEAR(values_bar[k], expected, rounding * (1.0 + std::abs(expected)))
          << space.columns()[k].name;
    }
  }
}

TEST(DesignSpace, RefusesWhatCannotBeExplored) {
  const auto refused = [&](const std::string& base, const std::string& variables) {
    return refusal(study_text(base, variables, "bending = {}", random_sampler));
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(refused(model1, "x = { vary = [\"shape.hod.*\"] }"),
              HasSubstr("study.toml:5: variables.x.vary: "));
  EXPECT_THAT(refused(model1, "x = { vary = [\"curve.*\"] }"),
              HasSubstr("has no bounds of its own"));
  EXPECT_THAT(refused(model1, "x = { vary = [\"shape.*\"], width = [0.1, 0.2] }"),
              HasSubstr("is for cuts"));
  EXPECT_THAT(refused(model1, "x = { vary = [\"cut.*\"] }\ny = { vary = [\"cut.hood.*\"] }"),
              HasSubstr("which \"x\" moves already"));
  EXPECT_THAT(refused(model1, "x = { vary = [\"curve.grille_bottom[0].z\"], factor = [0.9, 1.1] }"),
              HasSubstr("at 0; give an offset"));
  EXPECT_THAT(refused(model1, ""), HasSubstr("something must vary"));
}

TEST(DesignSpace, RefusesABlendOfDifferentBodies) {
  Study study = study_with(blend, "");
  std::swap(study.models[1].model.joints[3], study.models[1].model.joints[4]);
  try {
    DesignSpace space(study);
    FAIL() << "not refused";
  } catch (const explore::StudyError& error) {
    EXPECT_EQ(error.key(), "blend");
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("\"model1\" differs from \"template\" in the joint"));
  }
}

}  // namespace
}  // namespace bodyline::testing
