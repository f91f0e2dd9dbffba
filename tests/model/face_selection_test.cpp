#include "model/face_selection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "check_models.hpp"

/// Which faces a term of an objective sums up.
namespace bodyline::testing {
namespace {

using model::Stage;
using Patterns = std::vector<std::string>;

std::vector<std::string> chosen_names(Stage stage, const Patterns& patterns) {
  const model::BodyPlan plan = model::plan_body(load_car("model1"));
  std::vector<std::string> names;
  for (const model::Face* face : model::choose_faces(plan, stage, patterns))
    names.push_back(face->name);
  return names;
}

std::string refusal(Stage stage, const Patterns& patterns) {
  try {
    chosen_names(stage, patterns);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FaceSelection, NoPatternChoosesEveryFaceOfTheStage) {
  const model::BodyPlan plan = model::plan_body(load_car("model1"));
  for (const Stage stage : {Stage::base, Stage::kept, Stage::body})
    EXPECT_EQ(chosen_names(stage, {}).size(), plan.faces(stage).size());
}

TEST(FaceSelection, KeepsThePlansOrderAndNamesAFaceOnce) {
  EXPECT_THAT(chosen_names(Stage::base, {"roof", "hood", "hoo*"}),
              ::testing::ElementsAre("hood", "roof"));
}

TEST(FaceSelection, RefusesEachPatternThatMatchesNoFaceWithTheNearestName) {
  EXPECT_THAT(refusal(Stage::base, {"hod"}), ::testing::HasSubstr("\"hood\""));
  EXPECT_THAT(refusal(Stage::base, {"roof", "hod"}), ::testing::HasSubstr("\"hod\""));
}

TEST(FaceSelection, KnowsOnlyTheFacesOfTheStage) {
  EXPECT_THAT(refusal(Stage::kept, {"hood__windshield"}), ::testing::HasSubstr("stage kept"));
  EXPECT_THAT(chosen_names(Stage::body, {"hood__windshield"}),
              ::testing::ElementsAre("hood__windshield"));
}

}  // namespace
}  // namespace bodyline::testing
