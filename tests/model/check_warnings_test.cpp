#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check_models.hpp"

/// What a user is told of a body that is built as it should be.
namespace bodyline::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::vector<std::string> free_edge_warnings(const model::Model& car) {
  std::vector<std::string> found;
  for (const std::string& warning : model::check_body(car).warnings) {
    if (warning.find("free edge") != std::string::npos) found.push_back(warning);
  }
  return found;
}

// The wheel arches of models 1 and 2 rise above the door line at the rear, those of the template do
// not.
TEST(CheckWarnings, NameTheEndAtWhichATransitionLeavesTheFreeEdge) {
  const auto at_the_rear =
      AllOf(HasSubstr("door_upper__door_lower: at end 1"), HasSubstr("edge of door_lower"));
  for (const char* car : {"model1", "model2"})
    EXPECT_THAT(free_edge_warnings(load_car(car)), ::testing::ElementsAre(at_the_rear)) << car;
  EXPECT_THAT(free_edge_warnings(load_car("template")), ::testing::IsEmpty());
}

TEST(CheckWarnings, NameEveryPillarFootOnce) {
  for (const char* car : car_names) {
    const std::vector<std::string> warnings = model::check_body(load_car(car)).warnings;
    for (const char* foot : {"a_pillar_foot", "c_pillar_foot"}) {
      const auto is_of_foot = [&](const std::string& w) { return w.starts_with(foot); };
      EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), is_of_foot), 1) << car << foot;
    }
  }
}

TEST(CheckWarnings, AreOfTheFinishedBodyOnly) {
  for (const model::Stage stage : {model::Stage::base, model::Stage::kept})
    EXPECT_THAT(model::check_body(load_car("model1"), {stage}).warnings, ::testing::IsEmpty());
}

}  // namespace
}  // namespace bodyline::testing
