#include "explore/run_optimizer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "explore/hypervolume.hpp"
#include "explore/pareto.hpp"
#include "explore/tuned_source.hpp"
#include "optimizer_support.hpp"
#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::RunOptions;
using explore::RunProgress;
using explore::Study;
using explore::VariantPlan;
using explore::VariantStatus;

RunProgress run(const std::filesystem::path& path, const Study& study, const RunOptions& options,
                bool resume = false) {
  const auto plan = std::make_shared<VariantPlan>(study);
  explore::StoreWriter store =
      resume ? explore::StoreWriter::resume(path, study)
             : explore::StoreWriter::create(path, study, plan->space, explore::planned_rows(plan),
                                            false);
  RunProgress progress;
  if (explore::chooses_by_results(study)) {
    const explore::StoreReader begun(path);
    progress = explore::run_optimizer(plan, store, begun, options);
  } else {
    progress = explore::run_study(plan, *explore::plan_source(plan), store, options);
  }
  store.finish();
  return progress;
}

RunOptions on_threads(int threads) {
  RunOptions options;
  options.threads = threads;
  return options;
}

struct Kind {
  const char* name;
  std::string optimizer;
};
void PrintTo(const Kind& kind, std::ostream* stream) { *stream << kind.name; }

class Optimizer : public ::testing::TestWithParam<Kind> {};

TEST_P(Optimizer, HasTheSameBitsForAnyNumberOfThreads) {
  const Folder folder;
  const Study study = study_of(text_of(GetParam().optimizer));
  const RunProgress one = run(folder / "1.h5", study, on_threads(1));
  run(folder / "2.h5", study, on_threads(2));
  EXPECT_EQ(one.done, one.planned);
  EXPECT_EQ(one.done, std::uint64_t(all_rows(folder / "1.h5").count));
  EXPECT_TRUE(same_rows(all_rows(folder / "1.h5"), all_rows(folder / "2.h5")));
}

TEST_P(Optimizer, StoppedAndResumedIsTheSameAsUninterrupted) {
  const Folder folder;
  const Study study = study_of(text_of(GetParam().optimizer));
  run(folder / "whole.h5", study, on_threads(2));
  int parts = 0;
  RunProgress progress;
  do {
    RunOptions options = on_threads(2);
    std::atomic<int> polls{0};
    // Later and later: at first within the first rows, at last not at all.
    const int allowed = parts < 4 ? 2 * parts + 1 : 10000;
    options.should_stop = [&] { return ++polls > allowed; };
    progress = run(folder / "parts.h5", study, options, parts > 0);
    ++parts;
  } while (progress.done < progress.planned);
  EXPECT_GT(parts, 2);
  EXPECT_TRUE(same_rows(all_rows(folder / "whole.h5"), all_rows(folder / "parts.h5")));
}

TEST_P(Optimizer, GoesOnFromAnyRowToTheSameEnd) {
  const Folder folder;
  const Study study = study_of(text_of(GetParam().optimizer));
  run(folder / "whole.h5", study, on_threads(2));
  const explore::VariantRows whole = all_rows(folder / "whole.h5");
  const auto plan = std::make_shared<VariantPlan>(study);
  for (const int begun : {1, 5, 17}) {
    if (begun >= whole.count) continue;
    const auto path = folder / (std::to_string(begun) + ".h5");
    {
      explore::StoreWriter store = explore::StoreWriter::create(path, study, plan->space,
                                                                explore::planned_rows(plan), false);
      explore::VariantRows rows = explore::make_rows(store.layout(), 0, begun);
      explore::copy_rows(store.layout(), whole, 0, rows, 0, begun);
      store.append(rows);
      store.finish();
    }
    const RunProgress progress = run(path, study, on_threads(2), true);
    EXPECT_EQ(progress.measured, std::uint64_t(whole.count - begun));
    EXPECT_TRUE(same_rows(whole, all_rows(path))) << begun;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, Optimizer,
    ::testing::Values(Kind{"nsga2", nsga2 + "population = 12\ngenerations = 5"},
                      Kind{"moead", moead + "population = 12\ngenerations = 5"},
                      Kind{"front", front + "points = 20"},
                      Kind{"local",
                           local + "starts = { kind = \"sobol\", count = 20 }\nevaluations = 20"}),
    [](const auto& test) { return test.param.name; });

TEST(RunOptimizer, RefusesAStoreWithOtherVariants) {
  const Folder folder;
  const Study study = study_of(text_of(nsga2 + "population = 12\ngenerations = 2"));
  const auto plan = std::make_shared<VariantPlan>(study);
  {
    explore::StoreWriter store = explore::StoreWriter::create(folder / "a.h5", study, plan->space,
                                                              explore::planned_rows(plan), false);
    store.append(explore::make_rows(store.layout(), 0, 3));
    store.finish();
  }
  EXPECT_THAT([&] { run(folder / "a.h5", study, on_threads(1), true); },
              ::testing::ThrowsMessage<explore::StoreError>(
                  ::testing::HasSubstr("has other variants than the optimizer asks for")));
}

// Bending and closeness of valid rows.
std::vector<double> goals_of(const explore::VariantRows& rows) {
  std::vector<double> values;
  for (int row = 0; row < rows.count; ++row) {
    if (rows.status[row] != 0) continue;
    values.push_back(rows.metrics[std::size_t(3 * row)]);
    values.push_back(rows.metrics[std::size_t(3 * row + 1)]);
  }
  return values;
}

// A hundred variables.
const std::string many = R"(
shape = { vary = ["shape.*"], offset = [-0.1, 0.1] }
fullness = { vary = ["fullness.*.a", "fullness.rear*.b"], range = [1.0, 2.0] }
roof = { vary = ["curve.roof__side_window[1-4].z"], offset = [-20, 20] }
)";

TEST(RunOptimizer, TheFrontDominatesNsga2AtATenthOfItsEvaluations) {
  const Folder folder;
  run(folder / "nsga2.h5",
      study_of(text_of(nsga2 + "population = 100\ngenerations = 149", unfolded, many)),
      on_threads(2));
  const RunProgress progress = run(
      folder / "front.h5",
      study_of(text_of(front + "points = 70\nevaluations = 20", unfolded, many)), on_threads(2));
  const explore::VariantRows all = all_rows(folder / "nsga2.h5");
  const std::vector<double> evolved = goals_of(all),
                            traced = goals_of(all_rows(folder / "front.h5"));
  EXPECT_LE(progress.evaluations + progress.measured, std::uint64_t(all.count / 10));
  const std::vector<std::size_t> list = explore::pareto_set(evolved, 2);
  int better = 0, worse = 0;
  for (const std::size_t k : list) {
    bool dominated = false;
    for (std::size_t f = 0; f < traced.size() / 2; ++f) {
      dominated |= traced[2 * f] <= evolved[2 * k] && traced[2 * f + 1] <= evolved[2 * k + 1];
      worse += traced[2 * f] > evolved[2 * k] && traced[2 * f + 1] > evolved[2 * k + 1];
    }
    better += dominated;
  }
  EXPECT_EQ(worse, 0);
  std::vector<double> reference{0.0, 0.0};
  for (std::size_t k = 0; k < traced.size(); ++k)
    reference[k % 2] = std::max(reference[k % 2], traced[k]);
  const double ours = explore::hypervolume(traced, reference),
               theirs = explore::hypervolume(evolved, reference);
  EXPECT_GT(ours, theirs);
  RecordProperty("dominated", std::to_string(better) + " of " + std::to_string(list.size()));
  // Between neighbours of 70 points there is room for some that are not dominated.
  EXPECT_GT(better, 0.9 * double(list.size()));
}

TEST(RunOptimizer, RecordsVariantsThatFailAndGoesAroundThem) {
  const Folder folder;
  for (const std::string& kind : {nsga2, moead}) {
    const Study study = study_of(
        text_of(kind + "population = 32\ngenerations = 8",
                "[constraints]\nheight = { most = 1215 }\n" + unfolded,
                "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 3.2] }\n"
                "roof = { vary = [\"curve.roof__side_window[1-4].z\"], offset = [-20, 20] }"));
    const auto path = folder / (kind.substr(8, 5) + ".h5");
    const RunProgress progress = run(path, study, on_threads(2));
    EXPECT_EQ(progress.done, 32u * 9u);
    const explore::VariantRows rows = all_rows(path);
    const auto count = [&](VariantStatus status, int first, int last) {
      return std::count(rows.status.begin() + first, rows.status.begin() + last,
                        std::uint8_t(status));
    };
    EXPECT_GT(count(VariantStatus::fullness, 0, 32), 0);
    EXPECT_GT(count(VariantStatus::infeasible, 0, 32), 0);
    EXPECT_GT(count(VariantStatus::valid, rows.count - 32, rows.count),
              count(VariantStatus::valid, 0, 32));
  }
}

TEST(RunOptimizer, AFrontKeepsConstraints) {
  const Folder folder;
  const Study study = study_of(
      text_of(front + "points = 12", "[constraints]\nheight = { most = 1205 }\n" + unfolded));
  run(folder / "free.h5", study_of(text_of(front + "points = 12")), on_threads(2));
  run(folder / "kept.h5", study, on_threads(2));
  const explore::VariantRows kept = all_rows(folder / "kept.h5"),
                             free = all_rows(folder / "free.h5");
  int above = 0;
  for (int row = 0; row < free.count; ++row) above += free.metrics[std::size_t(3 * row + 2)] > 1205;
  EXPECT_GT(above, 0);
  for (int row = 0; row < kept.count; ++row) EXPECT_EQ(kept.status[row], 0) << row;
}

TEST(TunedSource, IsNeverWorseThanItsStart) {
  for (const std::string constraint : {"", "[constraints]\nheight = { most = 1205 }\n"}) {
    const Study study =
        study_of(text_of(local + "starts = { kind = \"random\", count = 12 }\nevaluations = 15",
                         constraint + unfolded));
    const auto plan = std::make_shared<VariantPlan>(study);
    const auto starts = explore::make_source(plan->study, plan->space);
    const auto tuned = explore::tuned_source(plan);
    explore::VariantEvaluator evaluator(plan);
    std::vector<double> row(std::size_t(plan->space.column_count())), before(3), after(3);
    int better = 0, mended = 0;
    for (std::uint64_t k = 0; k < 12; ++k) {
      starts->values(k, 1, row);
      const VariantStatus first = evaluator.measure(row, before).status;
      tuned->values(k, 1, row);
      const VariantStatus last = evaluator.measure(row, after).status;
      EXPECT_LE(last, first);
      if (last == first) {
        EXPECT_LE(after[0], before[0]);
      }
      better += after[0] < before[0];
      mended += last < first;
      for (std::size_t c = 0; c < row.size(); ++c) {
        EXPECT_GE(row[c], plan->space.columns()[c].lower);
        EXPECT_LE(row[c], plan->space.columns()[c].upper);
      }
    }
    EXPECT_GE(better, 10);
    if (!study.constraints.empty()) {
      EXPECT_GT(mended, 0);
    }
  }
}

TEST(TunedSource, KeepsTheCarOfAChoice) {
  const auto plan = std::make_shared<VariantPlan>(study_of(
      "format = 1\nname = \"x\"\nchoice = [\"model1.toml\", \"model2.toml\"]\n[variables]\n" + few +
      "\n[metrics]\nbending = {}\n[optimizer]\n" + local +
      "starts = { kind = \"random\", count = 6 }\nevaluations = 20\n" + unfolded));
  const auto starts = explore::make_source(plan->study, plan->space);
  const auto tuned = explore::tuned_source(plan);
  std::vector<double> row(std::size_t(plan->space.column_count())), end = row;
  std::vector<double> cars;
  for (std::uint64_t k = 0; k < 6; ++k) {
    starts->values(k, 1, row);
    tuned->values(k, 1, end);
    EXPECT_EQ(row[0], end[0]);
    EXPECT_NE(row, end);
    cars.push_back(row[0]);
  }
  EXPECT_THAT(cars, ::testing::IsSupersetOf({0.0, 1.0}));
}

TEST(TunedSource, WeighsItsGoals) {
  const auto bending_of = [](const std::string& weights) {
    const auto plan = std::make_shared<VariantPlan>(study_of(
        text_of("kind = \"local\"\nminimize = [\"bending\"]\nmaximize = [\"height\"]\nweights = " +
                weights + "\nstarts = { kind = \"random\", count = 1 }\nevaluations = 60")));
    std::vector<double> row(std::size_t(plan->space.column_count())), metrics(3);
    explore::tuned_source(plan)->values(0, 1, row);
    explore::VariantEvaluator(plan).measure(row, metrics);
    return metrics;
  };
  const std::vector<double> fair = bending_of("[1, 1e-6]"), high = bending_of("[1e-6, 1]");
  EXPECT_LT(fair[0], high[0]);
  EXPECT_LT(fair[2], high[2]);
}

}  // namespace
}  // namespace bodyline::testing
