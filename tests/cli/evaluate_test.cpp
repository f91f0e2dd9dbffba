#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using Json = nlohmann::json;

const std::string objective = "bending=1,variation=0.01,area=2,fold=3";

// What a fourth-order difference with these steps may be wrong by: its truncation, and the rounding
// of the values (some thousand nodes summed) over the step.
constexpr double truncation = 1e-6, rounding = 1e-12;

double step_of(const std::string& kind) {
  if (kind == "curve") return 0.05;
  return kind == "cut" ? 2e-4 : 1e-3;
}

class Evaluate : public testing::CommandLine {
 protected:
  // A body without folds: the energies are smooth around it.
  std::string smooth_car() const {
    EXPECT_EQ(bodyline({"set", car("model2"), "cut.*.?_lo=0.1", "cut.*.?_hi=0.9", "-o",
                        "smooth.toml", "--overwrite", "--quiet"})
                  .exit_code,
              0);
    return "smooth.toml";
  }

  Json evaluated(const std::string& model, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> command{"evaluate", model, "--objective", objective,
                                     "--nodes",  "16",  "--json",      "--quiet"};
    command.insert(command.end(), more.begin(), more.end());
    return json(command);
  }

  double value_at(const std::string& model, const std::string& name, double value) const {
    const Json number = value;  // shortest text that reads back as the same double
    EXPECT_EQ(bodyline({"set", model, name + "=" + number.dump(), "-o", "moved.toml", "--overwrite",
                        "--quiet"})
                  .exit_code,
              0);
    return evaluated("moved.toml").at("value");
  }

  double difference(const std::string& model, const Json& variable) const {
    const double h = step_of(variable.at("kind")), x = variable.at("value");
    const auto at = [&](double move) { return value_at(model, variable.at("name"), x + move * h); };
    return (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h);
  }
};

TEST_F(Evaluate, TheGradientIsTheDifferenceQuotientForEveryKindOfVariable) {
  const std::string model = smooth_car();
  const Json document = evaluated(model, {"--gradient"});
  const Json list = json({"variables", model, "--json", "--quiet"});
  std::map<std::string, std::vector<Json>> by_kind;
  for (const Json& variable : list.at("variables")) {
    by_kind[variable.at("kind")].push_back(variable);
  }
  EXPECT_EQ(by_kind.size(), 5U);
  const double noise = rounding * std::abs(document.at("value").get<double>());
  for (const auto& [kind, variables] : by_kind) {
    for (const std::size_t k : {std::size_t{0}, variables.size() / 2, variables.size() - 1}) {
      const std::string name = variables[k].at("name");
      const double derivative = document.at("gradient").at(name);
      EXPECT_NE(derivative, 0.0) << name;
      EXPECT_NEAR(difference(model, variables[k]), derivative,
                  truncation * std::abs(derivative) + noise / step_of(kind))
          << name;
    }
  }
}

TEST_F(Evaluate, JsonHasTheDocumentedKeys) {
  const Json document = evaluated(car("model1"), {"--vary", "shape.hood.*", "--gradient"});
  EXPECT_TRUE(document.at("value").is_number());
  EXPECT_EQ(document.at("terms").size(), 4U);
  for (const char* term : {"bending", "variation", "area", "fold"}) {
    EXPECT_TRUE(document.at("terms").at(term).is_number()) << term;
  }
  EXPECT_EQ(document.at("variables"), document.at("gradient").size());
  EXPECT_TRUE(document.at("gradient").at("shape.hood.u[0]").is_number());
  EXPECT_FALSE(evaluated(car("model1")).contains("gradient"));
}

TEST_F(Evaluate, TheValueIsTheWeightedSumOfTheTerms) {
  const Json document = evaluated(smooth_car());
  const Json& terms = document.at("terms");
  const double sum = terms.at("bending").get<double>() +
                     0.01 * terms.at("variation").get<double>() +
                     2.0 * terms.at("area").get<double>() + 3.0 * terms.at("fold").get<double>();
  EXPECT_NEAR(document.at("value"), sum, 1e-13 * std::abs(sum));
}

TEST_F(Evaluate, TermsOfFacesAddUpToTheTermOfAll) {
  const std::string model = smooth_car();
  const Json parts = json({"evaluate", model, "--stage", "base", "--objective",
                           "bending=1,bending@hood=1,bending@roof+*window=1", "--json", "--quiet"})
                         .at("terms");
  const Json names = json({"evaluate", model, "--stage", "base", "--objective",
                           "bending@roof=1,bending@*window=1", "--json", "--quiet"})
                         .at("terms");
  EXPECT_LT(parts.at("bending@hood"), parts.at("bending"));
  EXPECT_NEAR(parts.at("bending@roof+*window").get<double>(),
              names.at("bending@roof").get<double>() + names.at("bending@*window").get<double>(),
              1e-12 * parts.at("bending").get<double>());
}

TEST_F(Evaluate, TheHoodAsPrintedBends) {
  // The hood of model 1 with its printed shape; docs/mathematics.md, section 9.
  const double value = json({"evaluate", car("model1"), "--stage", "base", "--objective",
                             "bending@hood=1", "--json", "--quiet"})
                           .at("value");
  EXPECT_GT(value, 0.453412);
}

TEST_F(Evaluate, PatternsMayBeGivenTogetherOrOneByOne) {
  const Json together = evaluated(car("model1"), {"--vary", "shape.hood.*,cut.hood.*"});
  const Json single = evaluated(car("model1"), {"--vary", "shape.hood.*", "--vary", "cut.hood.*"});
  EXPECT_EQ(together, single);
  EXPECT_LT(single.at("variables"), evaluated(car("model1")).at("variables"));
}

TEST_F(Evaluate, TheTableNamesTheDerivatives) {
  const auto run =
      bodyline({"evaluate", car("model1"), "--vary", "shape.hood.u*", "--gradient", "--quiet"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, ::testing::HasSubstr("shape.hood.u[0]"));
  EXPECT_THAT(run.out, ::testing::HasSubstr("weighted sum"));
}

}  // namespace
}  // namespace bodyline
