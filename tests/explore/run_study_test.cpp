#include "explore/run_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::RunOptions;
using explore::RunProgress;
using explore::Study;
using explore::VariantPlan;
using explore::VariantStatus;

constexpr int count = 1000;

// Some variants break a constraint, some cannot be built.
Study mixed_study(const std::string& keep = "block = 128") {
  return study_of(study_text(
      "model = \"model1.toml\"",
      "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 3.05] }\n"
      "roof = { vary = [\"curve.roof__side_window[1-4].z\"], offset = [-20, 20] }",
      "bending = {}\nheight = {}\nlength = {}",
      "kind = \"sobol\"\ncount = " + std::to_string(count),
      "[constraints]\nheight = { most = 1215 }\n[checks]\nfolds = false\n[keep]\n" + keep));
}

RunProgress run(const std::filesystem::path& path, const Study& study, const RunOptions& options,
                bool resume = false) {
  const auto plan = std::make_shared<VariantPlan>(study);
  const auto source = explore::make_source(plan->study, plan->space);
  explore::StoreWriter store =
      resume ? explore::StoreWriter::resume(path, study)
             : explore::StoreWriter::create(path, study, plan->space, source->size(), false);
  const RunProgress progress = explore::run_study(plan, *source, store, options);
  store.finish();
  return progress;
}

RunOptions on_threads(int threads) {
  RunOptions options;
  options.threads = threads;
  return options;
}

TEST(RunStudy, HasTheSameBitsForAnyNumberOfThreads) {
  const Folder folder;
  for (const int threads : {1, 2, 5})
    run(folder / (std::to_string(threads) + ".h5"), mixed_study(), on_threads(threads));
  const explore::VariantRows one = all_rows(folder / "1.h5");
  EXPECT_EQ(one.count, count);
  EXPECT_TRUE(same_rows(one, all_rows(folder / "2.h5")));
  EXPECT_TRUE(same_rows(one, all_rows(folder / "5.h5")));
}

TEST(RunStudy, HasTheSameBitsWhateverTheBlocks) {
  const Folder folder;
  run(folder / "a.h5", mixed_study("block = 32"), on_threads(2));
  run(folder / "b.h5", mixed_study("block = 2048\ncompressed = false"), on_threads(2));
  EXPECT_TRUE(same_rows(all_rows(folder / "a.h5"), all_rows(folder / "b.h5")));
}

TEST(RunStudy, StoppedAndResumedIsTheSameAsUninterrupted) {
  const Folder folder;
  run(folder / "whole.h5", mixed_study(), on_threads(2));
  std::atomic<int> polls{0};
  RunOptions options = on_threads(2);
  options.should_stop = [&] { return ++polls % 3 == 0; };
  RunProgress progress = run(folder / "parts.h5", mixed_study(), options);
  int parts = 1;
  while (progress.done < std::uint64_t(count)) {
    progress = run(folder / "parts.h5", mixed_study(), options, true);
    ++parts;
  }
  EXPECT_GT(parts, 3);
  EXPECT_TRUE(same_rows(all_rows(folder / "whole.h5"), all_rows(folder / "parts.h5")));
}

TEST(RunStudy, RowsAreWhatOneEvaluatorMeasures) {
  const Folder folder;
  const Study study = mixed_study();
  run(folder / "a.h5", study, on_threads(2));
  const explore::VariantRows rows = all_rows(folder / "a.h5");
  const auto plan = std::make_shared<VariantPlan>(study);
  explore::VariantEvaluator evaluator(plan);
  std::vector<double> metrics(3);
  const auto list = variants(study, plan->space, 100);
  for (std::size_t row = 0; row < list.size(); ++row) {
    const explore::VariantOutcome outcome = evaluator.measure(list[row], metrics);
    EXPECT_EQ(rows.status[row], std::uint8_t(outcome.status));
    EXPECT_EQ(rows.cause[row], outcome.cause);
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::isnan(metrics[k])) {
        EXPECT_TRUE(std::isnan(rows.metrics[3 * row + k]));
      } else {
        EXPECT_EQ(rows.metrics[3 * row + k], metrics[k]);
      }
    }
    for (std::size_t k = 0; k < list[row].size(); ++k)
      EXPECT_EQ(rows.values[row * list[row].size() + k], list[row][k]);
  }
}

TEST(RunStudy, CountsWhatBecameOfVariants) {
  const Folder folder;
  const RunProgress progress = run(folder / "a.h5", mixed_study(), on_threads(2));
  const explore::VariantRows rows = all_rows(folder / "a.h5");
  RunProgress counted;
  explore::count_rows(rows, 3, counted);
  EXPECT_EQ(progress.by_status, counted.by_status);
  EXPECT_GT(progress.by_status[int(VariantStatus::valid)], 0u);
  EXPECT_GT(progress.by_status[int(VariantStatus::infeasible)], 0u);
  EXPECT_GT(progress.by_status[int(VariantStatus::fullness)], 0u);
  double best = 1e300;
  for (int row = 0; row < count; ++row) {
    if (rows.status[row] == 0) best = std::min(best, rows.metrics[std::size_t(3 * row)]);
  }
  EXPECT_EQ(progress.best, best);
  EXPECT_EQ(rows.metrics[3 * progress.best_row], best);
}

TEST(RunStudy, KeepsNetsAndThumbnails) {
  const Folder folder;
  const Study study = study_of(study_text(
      "model = \"model1.toml\"",
      "roof = { vary = [\"curve.roof__side_window[1-4].z\"], offset = [-20, 20] }", "bending = {}",
      "kind = \"star\"", "[checks]\nfolds = false\n[keep]\nnets = true\nthumbnails = 80"));
  run(folder / "a.h5", study, on_threads(2));
  const explore::VariantRows rows = all_rows(folder / "a.h5");
  ASSERT_EQ(rows.count, 9);
  const auto plan = std::make_shared<VariantPlan>(study);
  explore::VariantEvaluator evaluator(plan);
  const auto list = variants(study, plan->space, rows.count);
  for (std::size_t row = 0; row < list.size(); ++row) {
    double bending = 0.0;
    evaluator.measure(list[row], {&bending, 1});
    const std::size_t size = evaluator.nets().size();
    ASSERT_EQ(rows.nets.size(), size * list.size());
    for (std::size_t k = 0; k < size; ++k)
      ASSERT_EQ(rows.nets[row * size + k], float(evaluator.nets()[k]));
  }
  // A picture shows something: its pixels are not all alike, and variants do not all look the same.
  const std::size_t bytes = rows.thumbnails.size() / list.size();
  EXPECT_EQ(bytes, 64u * 80u * 3u);
  const auto picture = [&](std::size_t row) {
    return std::vector<std::uint8_t>(rows.thumbnails.begin() + std::ptrdiff_t(row * bytes),
                                     rows.thumbnails.begin() + std::ptrdiff_t((row + 1) * bytes));
  };
  EXPECT_NE(picture(0), std::vector<std::uint8_t>(bytes, picture(0)[0]));
  EXPECT_NE(picture(1), picture(2));
}

}  // namespace
}  // namespace bodyline::testing
