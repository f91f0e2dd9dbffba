#include "model/selection.hpp"

#include <gtest/gtest.h>

#include "io/read_model.hpp"
#include "model/build.hpp"

namespace bodyline::model {
namespace {

class Variables : public testing::TestWithParam<const char*> {
 protected:
  Model model = io::read_model(std::string(BODYLINE_SOURCE_DIR "/cars/") + GetParam() + ".toml");
  Connectivity links = connect(model);
  VariableMap map{model, links};
  Eigen::VectorXd parameters = to_parameters(model, map.layout());
};
INSTANTIATE_TEST_SUITE_P(Cars, Variables, testing::Values("template", "model1", "model2"));

TEST_P(Variables, ScatterOfGatherChangesNoBit) {
  const std::vector<std::string> all{"*"};
  const std::vector<int> selected = map.select(all);
  Eigen::VectorXd again = parameters;
  const Selection selection(map, selected);
  selection.scatter(selection.gather(parameters), again);
  EXPECT_EQ(again, parameters);
}

TEST_P(Variables, AnyMoveOfAnyVariableIsABuildableBody) {
  const std::vector<std::string> all{"curve.*", "shape.*", "fullness.*"};
  const std::vector<int> selected = map.select(all);
  const Selection selection(map, selected);
  Eigen::VectorXd x = selection.gather(parameters);
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] += 0.01 * std::sin(double(k));
  selection.scatter(x, parameters);
  set_parameters(model, map.layout(), parameters);
  EXPECT_NO_THROW(connect(model));
}

TEST_P(Variables, EveryCutMovesAndStaysABuildableBody) {
  const std::vector<std::string> cuts{"cut.*"};
  const std::vector<int> selected = map.select(cuts);
  Eigen::VectorXd x(selected.size());
  for (std::size_t k = 0; k < selected.size(); ++k) {
    const Variable& variable = map.variables()[selected[k]];
    x[Eigen::Index(k)] = 0.25 * variable.lower + 0.75 * variable.upper;
  }
  Selection(map, selected).scatter(x, parameters);
  set_parameters(model, map.layout(), parameters);
  EXPECT_NO_THROW(connect(model));
}

TEST_P(Variables, GatherPullbackIsTheAdjointOfScatter) {
  const std::vector<std::string> all{"*"};
  const std::vector<int> selected = map.select(all);
  const Eigen::VectorXd direction = Eigen::VectorXd::LinSpaced(map.count(), -1.0, 2.0);
  const Eigen::VectorXd bar = Eigen::VectorXd::LinSpaced(parameters.size(), 3.0, -1.0);
  Eigen::VectorXd moved = parameters, x_bar(map.count());
  const Selection selection(map, selected);
  selection.scatter(selection.gather(parameters) + direction, moved);
  selection.scatter_pullback(bar, x_bar);
  const double left = (moved - parameters).dot(bar), right = direction.dot(x_bar);
  EXPECT_NEAR(left, right, 1e-9 * std::abs(right));
}

TEST_P(Variables, ParametersHaveDistinctNames) {
  std::vector<std::string> names = map.parameter_names();
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST_P(Variables, PatchesThatShareASeamShareItsCut) {
  const std::vector<std::string> a{"cut.front_fender_upper.v_hi"}, b{"cut.door_upper.u_hi"},
      c{"cut.rear_fender_upper.v_hi"};
  EXPECT_EQ(map.select(a), map.select(b));
  EXPECT_EQ(map.select(a), map.select(c));
}

TEST_P(Variables, SymmetryPlaneAndFreeSidesDoNotMove) {
  // A free lower side of the grille, and the cut of door_upper towards the uncut joint.
  for (const char* name : {"cut.grille.u_lo", "cut.door_upper.u_lo"}) {
    const auto& names = map.parameter_names();
    const auto at = std::find(names.begin(), names.end(), name);
    ASSERT_NE(at, names.end());
    EXPECT_EQ(map.variable_of(int(at - names.begin())), -1);
  }
}

TEST(NamePattern, StarMatchesAnyRunAndDigitSetsMatchIndices) {
  EXPECT_TRUE(name_matches("shape.*", "shape.hood.u[0]"));
  EXPECT_TRUE(name_matches("curve.roof__*[1-2].z", "curve.roof__side_window[1].z"));
  EXPECT_FALSE(name_matches("curve.roof__*[1-2].z", "curve.roof__side_window[3].z"));
  EXPECT_TRUE(name_matches("curve.hood__windshield[1].z", "curve.hood__windshield[1].z"));
  EXPECT_TRUE(name_matches("*[03].y", "curve.a[3].y"));
  EXPECT_FALSE(name_matches("shape.hood", "shape.hood.u[0]"));
  EXPECT_TRUE(name_matches("lean.?.b[0]", "lean.x.b[0]"));
  EXPECT_FALSE(name_matches("", "x"));
  EXPECT_TRUE(name_matches("**", ""));
}

TEST(NamePattern, NothingMatchedIsSaidWithTheNearestName) {
  const Model model = io::read_model(BODYLINE_SOURCE_DIR "/cars/model1.toml");
  const VariableMap map(model, connect(model));
  const std::vector<std::string> wrong{"shape.hod.u[0]"};
  try {
    map.select(wrong);
    FAIL() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("shape.hood.u[0]"), std::string::npos);
  }
}

}  // namespace
}  // namespace bodyline::model
