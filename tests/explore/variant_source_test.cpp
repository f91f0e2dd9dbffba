#include "explore/variant_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study_support.hpp"

namespace bodyline::testing {
namespace {

const std::string model1 = "model = \"model1.toml\"";
const std::string shape = "fullness = { vary = [\"fullness.hood__*\"], range = [1.0, 2.0] }";

std::string with_sampler(const std::string& sampler) {
  return study_text(model1, shape, "bending = {}", sampler);
}

// Known without the points, which may take long to make.
TEST(SourceSize, IsThatOfTheSource) {
  for (const std::string sampler :
       {"kind = \"factorial\"\nlevels = 2", "kind = \"sobol\"\ncount = 9",
        "kind = \"halton\"\ncount = 9", "kind = \"latin\"\ncount = 9",
        "kind = \"latin_maximin\"\ncount = 9", "kind = \"random\"\ncount = 9",
        "kind = \"one_at_a_time\"\nlevels = 3", "kind = \"star\"",
        "kind = \"morris\"\ntrajectories = 2\nlevels = 4", "kind = \"saltelli\"\ncount = 8"}) {
    const explore::Study study = study_of(with_sampler(sampler));
    const explore::DesignSpace space(study);
    EXPECT_EQ(explore::source_size(study, space), explore::make_source(study, space)->size())
        << sampler;
  }
}

TEST(SourceSize, RefusesADesignThatIsTooLarge) {
  EXPECT_THAT(refusal(with_sampler("kind = \"latin_maximin\"\ncount = 2001")),
              ::testing::HasSubstr("sampler: a maximin design has at most 2000 points"));
}

}  // namespace
}  // namespace bodyline::testing
