#include "explore/body_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "explore/philox.hpp"
#include "model/connect.hpp"
#include "model/evaluator.hpp"
#include "model/parameters.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::VariantOutcome;
using explore::VariantStatus;

// The quick rules and the reader of models agree on what can be built.
TEST(BodyRules, AgreeWithConnect) {
  const model::Model model = small_study(1).models.front().model;
  const model::BodyContext context(model);
  const explore::BodyRules rules(model, context.plan);
  const explore::PlacedRandom random(11, 99);
  std::map<VariantStatus, int> seen;
  for (std::uint64_t n = 0; n < 600; ++n) {
    Eigen::VectorXd parameters = context.parameters;
    // One variable that is no point, moved beyond its limits or not.
    std::vector<int> others;
    for (int k = 0; k < context.map.count(); ++k) {
      if (context.map.variables()[k].kind != model::ParameterKind::curve) others.push_back(k);
    }
    const auto draw = random.uniform(n, 0);
    const model::Variable& variable =
        context.map.variables()[others[std::size_t(draw[0] * double(others.size()))]];
    double value = -1.0 + 5.0 * draw[1];
    if (n % 5 == 0) value = std::round(value);      // limits themselves
    if (n % 7 == 0) value = 1e3 * (draw[1] - 0.5);  // far out
    for (const model::Tie& tie : variable.ties)
      parameters[tie.parameter] = tie.factor * value + tie.offset;
    model::Model moved = model;
    model::set_parameters(moved, context.plan.layout, parameters);
    std::string key;
    try {
      model::connect(moved);
    } catch (const model::ModelError& error) {
      key = error.key();
    }
    const VariantOutcome outcome = rules.check(parameters);
    ++seen[outcome.status];
    EXPECT_EQ(outcome.status == VariantStatus::valid, key.empty())
        << variable.name << " " << value << " " << key;
    const std::map<VariantStatus, std::string> keys{{VariantStatus::valid, ""},
                                                    {VariantStatus::cut_order, ".cut."},
                                                    {VariantStatus::fullness, ".fullness"},
                                                    {VariantStatus::lean, ".lean."}};
    EXPECT_THAT(key, ::testing::HasSubstr(keys.at(outcome.status)));
    if (outcome.cause == explore::no_cause) continue;
    const std::string& face = context.plan.body_faces[outcome.cause - 1].name;
    EXPECT_THAT(key, ::testing::HasSubstr("." + face + ".")) << value;
  }
  for (const VariantStatus status : {VariantStatus::valid, VariantStatus::cut_order,
                                     VariantStatus::fullness, VariantStatus::lean})
    EXPECT_GT(seen[status], 0) << explore::status_name(status);
}

}  // namespace
}  // namespace bodyline::testing
