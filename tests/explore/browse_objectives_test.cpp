#include <gtest/gtest.h>

#include "explore/browse_rows.hpp"
#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

// How far a car is from its drawings is rather wanted small than its height.
TEST(BrowseObjectives, BeginWithWhatShouldBeSmall) {
  const Folder folder;
  const explore::Study study = study_of(study_text(
      "model = \"model1.toml\"", "a = { vary = [\"fullness.hood*\"], range = [1.0, 2.0] }",
      "height = {}\nwidth = {}\noutline = { views = \"side=a.svg\" }", "kind = \"star\""));
  new_store(folder / "a.h5", study, 4).finish();
  const auto objectives = explore::browse_objectives(explore::StoreReader(folder / "a.h5"), {}, {});
  ASSERT_EQ(objectives.size(), 2u);
  EXPECT_TRUE(objectives[0].column.is_metric);
  EXPECT_EQ(objectives[0].column.index, 2);
  EXPECT_EQ(objectives[1].column.index, 0);
}

}  // namespace
}  // namespace bodyline::testing
