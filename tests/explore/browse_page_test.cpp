#include "explore/browse_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "explore/browse_bodies.hpp"
#include "explore/browse_rows.hpp"
#include "explore/pareto.hpp"
#include "explore/run_study.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::BrowseRows;
using explore::StoreReader;

constexpr int variables = 8;
// Nets are kept as 32-bit numbers: half a step of one at a car's length.
constexpr float rounding_mm = 5e-4f;

// The store of a small study, measured.
StoreReader measured(const Folder& folder, int count, const std::string& rest = "") {
  const auto path = folder / "space.h5";
  const explore::Study study = small_study(count, "[checks]\nfolds = false\n" + rest);
  const auto plan = std::make_shared<const explore::VariantPlan>(study);
  const auto source = explore::make_source(plan->study, plan->space);
  auto store = explore::StoreWriter::create(path, study, plan->space, source->size(), false);
  explore::run_study(plan, *source, store);
  store.finish();
  return StoreReader(path);
}

std::vector<explore::StoreObjective> both_metrics(const StoreReader& store) {
  return explore::browse_objectives(store, {"bending"}, {"height"});
}

std::vector<std::uint64_t> pareto_ids(const BrowseRows& rows) {
  std::vector<std::uint64_t> ids;
  for (const int row : rows.pareto) ids.push_back(rows.ids[row]);
  return ids;
}

// Squared, each metric over its range.
double metric_distance(const BrowseRows& rows, int a, int b) {
  double sum = 0.0;
  for (int k = variables; k < variables + 2; ++k) {
    const auto& column = rows.columns[k];
    const auto [least, most] = std::minmax_element(column.begin(), column.end());
    const double step = (column[a] - column[b]) / (*most - *least);
    sum += step * step;
  }
  return sum;
}

TEST(BrowseRows, AreAllOfTheStoreWithAllTheirBits) {
  const Folder folder;
  const StoreReader store = measured(folder, 50);
  const BrowseRows rows = explore::browse_rows(store, both_metrics(store), 50);
  const explore::VariantRows all = store.read(0, 50);
  ASSERT_EQ(rows.count(), 50);
  for (int row = 0; row < 50; ++row) {
    EXPECT_EQ(rows.ids[row], std::uint64_t(row));
    for (int k = 0; k < variables; ++k)
      EXPECT_EQ(rows.columns[k][row], all.values[row * variables + k]);
    for (int k = 0; k < 2; ++k)
      EXPECT_EQ(rows.columns[variables + k][row], all.metrics[row * 2 + k]);
  }
}

TEST(BrowseRows, KeepTheWholeParetoSetInASample) {
  const Folder folder;
  const StoreReader store = measured(folder, 200);
  const auto objectives = both_metrics(store);
  const BrowseRows all = explore::browse_rows(store, objectives, 200);
  const BrowseRows sample = explore::browse_rows(store, objectives, 40);
  EXPECT_EQ(sample.count(), 40);
  ASSERT_GT(all.pareto.size(), 2u);
  EXPECT_EQ(pareto_ids(sample), pareto_ids(all));
}

TEST(BrowseRows, KeepTheWholeParetoSetWhereItExceedsTheLimit) {
  const Folder folder;
  const StoreReader store = measured(folder, 200);
  const auto objectives = both_metrics(store);
  const BrowseRows sample = explore::browse_rows(store, objectives, 2);
  EXPECT_GT(sample.count(), 2);
  EXPECT_EQ(sample.ids, pareto_ids(sample));
}

TEST(BrowseRows, OfASampleAreEvenlySpread) {
  const Folder folder;
  const StoreReader store = measured(folder, 200);
  const BrowseRows sample = explore::browse_rows(store, {}, 40);
  std::set<std::uint64_t> parts;
  for (const std::uint64_t id : sample.ids) parts.insert(id / 5);
  EXPECT_EQ(sample.count(), 40);
  EXPECT_EQ(parts.size(), 40u);
}

TEST(BrowseRows, HaveTheParetoSetOfTheirMetrics) {
  const Folder folder;
  const StoreReader store = measured(folder, 100);
  const BrowseRows rows = explore::browse_rows(store, both_metrics(store), 100);
  std::vector<double> costs;
  for (int row = 0; row < rows.count(); ++row) {
    costs.push_back(rows.columns[variables][row]);
    costs.push_back(-rows.columns[variables + 1][row]);
  }
  std::vector<int> expected;
  for (const std::size_t row : explore::pareto_set(costs, 2)) expected.push_back(int(row));
  EXPECT_EQ(rows.pareto, expected);
}

// Metrics of a made-up variant, scattered.
double scattered(std::uint64_t id, int metric) {
  return std::fmod(double(id + 1) * (metric == 0 ? 0.6180339887498949 : 0.7548776662466927), 1.0);
}

TEST(BrowseRows, HaveTheParetoSetOfAStoreThatIsLargerThanWhatIsHeldAtOnce) {
  constexpr int count = 200000, at_once = 20000;
  const Folder folder;
  const explore::Study study = small_study(count);
  const explore::DesignSpace space(study);
  auto store = explore::StoreWriter::create(folder / "a.h5", study, space, count, false);
  std::vector<double> costs;
  for (int first = 0; first < count; first += at_once) {
    auto rows = explore::make_rows(store.layout(), std::uint64_t(first), at_once);
    for (int k = 0; k < 2 * at_once; ++k)
      rows.metrics[k] = scattered(std::uint64_t(first + k / 2), k % 2);
    costs.insert(costs.end(), rows.metrics.begin(), rows.metrics.end());
    store.append(rows);
  }
  store.finish();
  std::vector<std::uint64_t> expected;
  for (const std::size_t row : explore::pareto_set(costs, 2)) expected.push_back(row);
  const StoreReader reader(folder / "a.h5");
  const BrowseRows shown = explore::browse_rows(
      reader, explore::browse_objectives(reader, {"bending", "height"}, {}), 1000);
  EXPECT_GT(expected.size(), 5u);
  EXPECT_EQ(pareto_ids(shown), expected);
  for (int row = 0; row < shown.count(); ++row)
    EXPECT_EQ(shown.columns[variables][row], scattered(shown.ids[row], 0));
}

TEST(BrowseObjectives, AreTwoMetricsToBeSmallUnlessGiven) {
  const Folder folder;
  const StoreReader store = measured(folder, 4);
  const auto objectives = explore::browse_objectives(store, {}, {});
  ASSERT_EQ(objectives.size(), 2u);
  EXPECT_TRUE(objectives[0].minimize);
  EXPECT_EQ(objectives[0].column.index, 0);
}

TEST(BrowseObjectives, RefuseOneAlone) {
  const Folder folder;
  const StoreReader store = measured(folder, 4);
  EXPECT_THROW(explore::browse_objectives(store, {"bending"}, {}), std::invalid_argument);
}

TEST(SpreadRows, BeginWithTheParetoSetAndNeverRepeat) {
  const Folder folder;
  const StoreReader store = measured(folder, 60);
  const BrowseRows rows = explore::browse_rows(store, both_metrics(store), 60);
  const std::vector<int> spread = explore::spread_rows(rows, variables, 30);
  ASSERT_EQ(spread.size(), 30u);
  EXPECT_TRUE(std::equal(rows.pareto.begin(), rows.pareto.end(), spread.begin()));
  EXPECT_EQ(std::set<int>(spread.begin(), spread.end()).size(), 30u);
}

TEST(SpreadRows, LeaveNoneFartherAwayThanTheyAreFromEachOther) {
  const Folder folder;
  const StoreReader store = measured(folder, 60);
  const BrowseRows rows = explore::browse_rows(store, {}, 60);
  const std::vector<int> spread = explore::spread_rows(rows, variables, 20);
  const auto nearest = [&](int row) {
    double least = std::numeric_limits<double>::infinity();
    for (const int other : spread) {
      if (other != row) least = std::min(least, metric_distance(rows, row, other));
    }
    return least;
  };
  double covering = 0.0, separation = std::numeric_limits<double>::infinity();
  for (int row = 0; row < rows.count(); ++row) {
    const bool chosen = std::find(spread.begin(), spread.end(), row) != spread.end();
    if (chosen) separation = std::min(separation, nearest(row));
    if (!chosen) covering = std::max(covering, nearest(row));
  }
  EXPECT_GT(covering, 0.0);
  EXPECT_LE(covering, separation);
}

TEST(SpreadRows, LeaveOutWhatCannotBeBuilt) {
  const Folder folder;
  const StoreReader store = measured(folder, 10);
  BrowseRows rows = explore::browse_rows(store, {}, 10);
  rows.status[3] = std::uint8_t(explore::VariantStatus::cut_order);
  const std::vector<int> spread = explore::spread_rows(rows, variables, 10);
  EXPECT_EQ(spread.size(), 9u);
  EXPECT_THAT(spread, ::testing::Not(::testing::Contains(3)));
}

TEST(SpreadRows, AreNoneWhereNothingCanBeBuilt) {
  const Folder folder;
  const StoreReader store = measured(folder, 3);
  BrowseRows rows = explore::browse_rows(store, {}, 3);
  for (auto& status : rows.status) status = std::uint8_t(explore::VariantStatus::lean);
  EXPECT_THAT(explore::spread_rows(rows, variables, 10), ::testing::IsEmpty());
}

TEST(BrowseBodies, AreTheSameFromTheStoreAndBuiltAnew) {
  const Folder with, without;
  const StoreReader kept = measured(with, 6, "[keep]\nnets = true\n");
  const StoreReader bare = measured(without, 6);
  const auto a = explore::browse_bodies(kept, explore::browse_rows(kept, {}, 6), {5, 2});
  const auto b = explore::browse_bodies(bare, explore::browse_rows(bare, {}, 6), {5, 2});
  EXPECT_EQ(a.rows, (std::vector<int>{2, 5}));
  ASSERT_EQ(a.points_mm.size(), b.points_mm.size());
  ASSERT_EQ(a.points_mm.size(), std::size_t(2 * 3 * a.points));
  for (std::size_t k = 0; k < a.points_mm.size(); ++k)
    ASSERT_NEAR(a.points_mm[k], b.points_mm[k], rounding_mm) << k;
}

TEST(BrowsePage, IsRefusedOfAnEmptyStore) {
  const Folder folder;
  const explore::Study study = small_study(3);
  const explore::VariantPlan plan(study);
  explore::StoreWriter::create(folder / "a.h5", study, plan.space, 3, false).finish();
  explore::BrowseSummary summary;
  EXPECT_THROW(explore::browse_page(StoreReader(folder / "a.h5"), {}, summary),
               explore::StoreError);
}

TEST(BrowsePage, LoadsNothing) {
  const Folder folder;
  const StoreReader store = measured(folder, 5);
  explore::BrowseSummary summary;
  const std::string page = explore::browse_page(store, {}, summary);
  EXPECT_THAT(page, ::testing::HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, ::testing::Not(::testing::HasSubstr(" src=\"http")));
  EXPECT_EQ(summary.shown, 5);
  EXPECT_EQ(summary.bodies, 5);
}

TEST(BrowsePage, KeepsTextOfTheStudyFromEndingItsElements) {
  const Folder folder;
  std::string text = study_text("model = \"model1.toml\"",
                                "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 2.0] }",
                                "bending = {}", "kind = \"random\"\ncount = 2");
  text.replace(text.find("\"test\""), 6, "\"</script><b>\"");
  const explore::Study study = study_of(text);
  const auto plan = std::make_shared<const explore::VariantPlan>(study);
  const auto source = explore::make_source(plan->study, plan->space);
  auto writer = explore::StoreWriter::create(folder / "a.h5", study, plan->space, 2, false);
  explore::run_study(plan, *source, writer);
  writer.finish();
  explore::BrowseSummary summary;
  const std::string page = explore::browse_page(StoreReader(folder / "a.h5"), {}, summary);
  EXPECT_THAT(page, ::testing::Not(::testing::HasSubstr("</script><b>")));
}

}  // namespace
}  // namespace bodyline::testing
