#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

class Set : public testing::CommandLine {
 protected:
  double value(const std::string& model, const std::string& name) const {
    const Json document = json({"variables", model, name, "--fixed", "--json"});
    for (const Json& variable : document.at("variables")) {
      if (variable.at("name") == name) return variable.at("value");
      for (const Json& tie : variable.at("ties")) {
        if (tie.at("name") != name) continue;
        return tie.at("factor").get<double>() * variable.at("value").get<double>() +
               tie.at("offset").get<double>();
      }
    }
    ADD_FAILURE() << name << " is not listed";
    return 0.0;
  }
};

struct Case {
  std::string name;
  double number;
};

TEST_F(Set, ShowsTheNumberThatWasSetForEveryKind) {
  const std::vector<Case> cases{{"shape.hood.u[0]", -0.1},
                                {"cut.hood.u_lo", 0.07},
                                {"fullness.hood__windshield.a", 1.1},
                                {"curve.hood__windshield[1].z", 830.3}};
  for (const auto& [name, number] : cases) {
    const auto run = bodyline({"set", car("model1"), name + "=" + std::to_string(number), "-o",
                               "new.toml", "--overwrite"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(value("new.toml", name), number) << name;
  }
}

TEST_F(Set, WhatIsTiedFollows) {
  ASSERT_EQ(bodyline({"set", car("model1"), "curve.hood__windshield[1].y=-310.25", "-o", "a.toml"})
                .exit_code,
            0);
  EXPECT_EQ(value("a.toml", "curve.hood__windshield[2].y"), 310.25);
  ASSERT_EQ(bodyline({"set", car("model1"), "cut.hood.v_hi=0.95", "-o", "b.toml"}).exit_code, 0);
  EXPECT_NEAR(value("b.toml", "cut.hood.v_lo"), 0.05, 1e-15);
}

TEST_F(Set, APointSharedByCurvesMovesInAllOfThem) {
  ASSERT_EQ(
      bodyline({"set", car("model1"), "curve.hood__windshield[0].z+=4", "-o", "a.toml"}).exit_code,
      0);
  for (const std::string name :
       {"curve.hood__windshield[0].z", "curve.hood__windshield[3].z",
        "curve.windshield__side_window[0].z", "curve.side_window__door_upper[0].z"}) {
    EXPECT_EQ(value("a.toml", name), value(car("model1"), name) + 4.0) << name;
  }
}

TEST_F(Set, APatternSetsAllItMatchesAndSkipsWhatIsFixed) {
  ASSERT_EQ(bodyline({"set", car("model1"), "cut.*.?_lo=0.1", "cut.*.?_hi=0.9", "-o", "a.toml"})
                .exit_code,
            0);
  const Json cuts = json({"variables", "a.toml", "cut.*", "--json"});
  for (const Json& variable : cuts.at("variables")) {
    const std::string name = variable.at("name");
    EXPECT_NEAR(variable.at("value").get<double>(), name.ends_with("_lo") ? 0.1 : 0.9, 1e-15)
        << name;
  }
  EXPECT_EQ(value(car("model1"), "cut.hood.u_lo") == 0.1, false) << "the test would show nothing";
}

TEST_F(Set, RelativeValuesAddSubtractAndMultiply) {
  const std::string name = "fullness.hood__windshield.a";
  const double before = value(car("model1"), name);
  ASSERT_EQ(bodyline({"set", car("model1"), name + "+=0.25", "-o", "a.toml"}).exit_code, 0);
  ASSERT_EQ(bodyline({"set", car("model1"), name + "-=0.25", "-o", "b.toml"}).exit_code, 0);
  ASSERT_EQ(bodyline({"set", car("model1"), name + "=*0.5", "-o", "c.toml"}).exit_code, 0);
  EXPECT_EQ(value("a.toml", name), before + 0.25);
  EXPECT_EQ(value("b.toml", name), before - 0.25);
  EXPECT_EQ(value("c.toml", name), before * 0.5);
}

TEST_F(Set, AssignmentsActOneAfterTheOther) {
  const std::string name = "fullness.hood__windshield.a";
  ASSERT_EQ(bodyline({"set", car("model1"), name + "=1", name + "+=0.5", "-o", "a.toml"}).exit_code,
            0);
  EXPECT_EQ(value("a.toml", name), 1.5);
}

TEST_F(Set, NothingElseChanges) {
  ASSERT_EQ(bodyline({"convert", car("model1"), "-o", "same.toml"}).exit_code, 0);
  ASSERT_EQ(bodyline({"set", car("model1"), "cut.hood.u_lo+=0", "-o", "a.toml"}).exit_code, 0);
  EXPECT_EQ(text("a.toml"), text("same.toml"));
}

TEST_F(Set, TheInputStaysAsItIs) {
  write("car.toml", testing::text_of(car("model1")));
  ASSERT_EQ(bodyline({"set", "car.toml", "cut.hood.u_lo=0.1", "-o", "car.toml"}).exit_code, 2);
  EXPECT_EQ(text("car.toml"), testing::text_of(car("model1")));
  ASSERT_EQ(
      bodyline({"set", "car.toml", "cut.hood.u_lo=0.1", "-o", "car.toml", "--overwrite"}).exit_code,
      0);
  EXPECT_EQ(value("car.toml", "cut.hood.u_lo"), 0.1);
}

TEST_F(Set, WarnsOfWhatItWrote) {
  const auto run = bodyline({"set", car("template"), "shape.hood.u[0]=-100", "-o", "a.toml"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("patches.hood.shape.u[0]: is -100"));
}

}  // namespace
}  // namespace bodyline
