#include <gmock/gmock.h>

#include <set>

#include "model/parameters.hpp"
#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

class Variables : public testing::CommandLine {};

TEST_F(Variables, JsonHasTheDocumentedKeys) {
  const Json document = json({"variables", car("model1"), "--json"});
  ASSERT_FALSE(document.at("variables").empty());
  for (const Json& variable : document.at("variables")) {
    EXPECT_TRUE(variable.at("name").is_string());
    EXPECT_TRUE(variable.at("kind").is_string());
    EXPECT_TRUE(variable.at("value").is_number());
    EXPECT_TRUE(variable.at("ties").is_array());
    const bool curve = variable.at("kind") == "curve";
    EXPECT_EQ(variable.at("lower").is_null(), curve);
    EXPECT_EQ(variable.at("upper").is_null(), curve);
  }
}

TEST_F(Variables, CountsAddUpToWhatIsListed) {
  const Json document = json({"variables", car("template"), "--json"});
  std::map<std::string, int> counts;
  for (const Json& variable : document.at("variables")) ++counts[variable.at("kind")];
  int total = 0;
  for (const std::string kind : {"shape", "cut", "fullness", "lean", "curve"}) {
    EXPECT_EQ(document.at("counts").at(kind), counts[kind]) << kind;
    EXPECT_GT(counts[kind], 0) << kind;
    total += counts[kind];
  }
  EXPECT_EQ(document.at("counts").at("total"), total);
}

TEST_F(Variables, NoNumberBelongsToTwoVariables) {
  const Json document = json({"variables", car("model2"), "--fixed", "--json"});
  std::set<std::string> names;
  const auto take = [&names](const std::string& name) {
    EXPECT_TRUE(names.insert(name).second) << name << " is listed twice";
  };
  for (const Json& variable : document.at("variables")) {
    take(variable.at("name"));
    for (const Json& tie : variable.at("ties")) take(tie.at("name"));
  }
  for (const Json& number : document.at("fixed")) take(number.at("name"));
}

TEST_F(Variables, PatternsSelect) {
  const Json hood = json({"variables", car("model1"), "shape.hood.*", "--json"});
  ASSERT_FALSE(hood.at("variables").empty());
  for (const Json& variable : hood.at("variables")) {
    EXPECT_THAT(variable.at("name").get<std::string>(), ::testing::StartsWith("shape.hood."));
  }
}

TEST_F(Variables, APatternThatMatchesNothingIsAnErrorEvenBesideOthers) {
  EXPECT_EQ(bodyline({"variables", car("model1"), "shape.hood.*", "shape.hod.*"}).exit_code, 2);
}

TEST_F(Variables, AMirroredPointMovesWithItsPartner) {
  const Json document = json({"variables", car("model1"), "curve.hood__windshield[1].y", "--json"});
  ASSERT_EQ(document.at("variables").size(), 1U);
  const Json& ties = document.at("variables")[0].at("ties");
  ASSERT_EQ(ties.size(), 1U);
  EXPECT_EQ(ties[0].at("name"), "curve.hood__windshield[2].y");
  EXPECT_EQ(ties[0].at("factor"), -1.0);
}

TEST_F(Variables, FixedNumbersAreListedOnlyWhenAsked) {
  const std::vector<std::string> command{"variables", car("model1"), "cut.grille.u_lo"};
  const auto refused = bodyline(command);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("fixed"));
  const auto listed = bodyline({"variables", car("model1"), "cut.grille.u_lo", "--fixed"});
  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_THAT(listed.out, HasSubstr("cut.grille.u_lo"));
}

TEST_F(Variables, TheTableEndsWithTheCountPerKind) {
  const auto run = bodyline({"variables", car("model1"), "shape.hood.*", "cut.hood.*"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, ::testing::ContainsRegex("[0-9]+ of [0-9]+ independent variables: "
                                                "[0-9]+ shape, [0-9]+ cut\n$"));
}

TEST_F(Variables, WarningsOfTheFileGoToTheErrorStreamOnceAndCanBeTurnedOff) {
  ASSERT_EQ(bodyline({"set", car("template"), "shape.hood.u[0]=-9", "-o", "odd.toml"}).exit_code,
            0);
  const auto loud = bodyline({"variables", "odd.toml", "cut.*", "--json"});
  EXPECT_TRUE(Json::accept(loud.out));
  EXPECT_THAT(loud.err, ::testing::MatchesRegex("bodyline: warning: odd.toml:[0-9]+: [^\n]*\n"));
  EXPECT_EQ(bodyline({"variables", "odd.toml", "cut.*", "--quiet"}).err, "");
}

}  // namespace
}  // namespace bodyline
