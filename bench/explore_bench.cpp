#include "bench/explore_bench.hpp"

#include <benchmark/benchmark.h>
#include <stdlib.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "bench/peers/store_peers.hpp"
#include "explore/measure_rows.hpp"
#include "explore/measure_study.hpp"
#include "explore/read_study.hpp"
#include "explore/run_study.hpp"

namespace bodyline::bench {
namespace {

namespace fs = std::filesystem;

constexpr int variants = 100000;   // of a run
constexpr int few = 10000;         // of a run that is to scale to two threads
constexpr int table_rows = 10000;  // that stores are given
constexpr int one_by_one = 100;    // rows that SQLite makes safe one by one: it is slow
constexpr int task_rows = 64;      // of the bare loop, as in run_study

// A folder for the life of the program.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "bodyline-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  /// A name that is free.
  fs::path fresh(const std::string& name) const {
    for (const auto& entry : fs::directory_iterator(path_)) fs::remove(entry.path());
    return path_ / name;
  }

 private:
  fs::path path_;
};

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The study, its variants, and what is measured of them.
struct Family {
  explicit Family(int count, bool compressed)
      : plan(std::make_shared<explore::VariantPlan>(read(count, compressed))),
        source(explore::make_source(plan->study, plan->space)) {}

  // The text is what a store keeps and goes by.
  static explore::Study read(int count, bool compressed) {
    const fs::path path = BODYLINE_SOURCE_DIR "/examples/sweep.toml";
    std::string text = text_of(path);
    const std::string planned = "count = 20000";
    text.replace(text.find(planned), planned.size(), "count = " + std::to_string(count));
    if (!compressed) text += "\n[keep]\ncompressed = false\n";
    return explore::read_study_text(
        text, path, [&](const std::string& name) { return text_of(path.parent_path() / name); });
  }

  std::shared_ptr<const explore::VariantPlan> plan;
  std::unique_ptr<explore::VariantSource> source;
  Folder folder;
};
using FamilyPointer = std::shared_ptr<const Family>;

void add(const std::string& name, const std::function<void()>& work) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [work](benchmark::State& state) {
                                 for (auto _ : state) work();
                               })
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}

explore::StoreWriter new_store(const Family& family) {
  return explore::StoreWriter::create(family.folder.fresh("a.h5"), family.plan->study,
                                      family.plan->space, family.source->size(), false);
}

// The whole of `bodyline explore` but reading the study: a new store, all variants, all on the
// disk.
void run_stored(const Family& family, int threads) {
  explore::StoreWriter store = new_store(family);
  explore::RunOptions options;
  options.threads = threads;
  explore::run_study(family.plan, *family.source, store, options);
  store.finish();
}

void run_without_store(const Family& family, const explore::VariantSource& source, int threads) {
  double sum = 0.0;
  explore::measure_study(family.plan, source, threads,
                         [&](const explore::VariantRows& rows) { sum += rows.metrics.front(); });
  benchmark::DoNotOptimize(sum);
}

// The bare loop: the same variants by the same evaluators, rows used once and forgotten.
void run_bare(const Family& family, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(threads));
  const explore::StoreLayout layout(family.plan->study, family.plan->space);
  tbb::enumerable_thread_specific<explore::VariantEvaluator> evaluators(
      [&] { return explore::VariantEvaluator(family.plan); });
  tbb::task_arena(threads).execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, variants, task_rows), [&](const tbb::blocked_range<int>& range) {
          const auto rows = explore::measure_range(evaluators.local(), layout, *family.source,
                                                   std::uint64_t(range.begin()), int(range.size()));
          benchmark::DoNotOptimize(rows->metrics.front());
        });
  });
}

/// All variants' values beforehand, as pagmo's batch evaluator takes them.
struct Points : explore::VariantSource {
  explicit Points(const Family& family)
      : columns(family.plan->space.columns().size()), all(columns * variants) {
    for (const explore::Column& column : family.plan->space.columns()) {
      lower.push_back(column.lower);
      upper.push_back(column.upper);
    }
    family.source->values(0, variants, all);
  }
  std::uint64_t size() const override { return variants; }
  void values(std::uint64_t first, int count, std::span<double> rows) const override {
    std::copy_n(all.begin() + std::ptrdiff_t(first * columns), std::size_t(count) * columns,
                rows.begin());
  }
  std::size_t columns;
  std::vector<double> lower, upper, all;
};

void run_pagmo(const Family& family, const Points& points, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(threads));
  tbb::enumerable_thread_specific<explore::VariantEvaluator> evaluators(
      [&] { return explore::VariantEvaluator(family.plan); });
  const std::size_t count = family.plan->study.metrics.size();
  const auto fitness = [&](std::span<const double> point) {
    double metrics[64];
    evaluators.local().measure(point, {metrics, count});
    return metrics[0];
  };
  benchmark::DoNotOptimize(pagmo_batch(points.lower, points.upper, points.all, fitness));
}

void add_runs(const FamilyPointer& plain, const FamilyPointer& compressed) {
  const auto points = std::make_shared<Points>(*plain);
  add("explore/two_threads", [=] { run_stored(*compressed, 2); });
  const auto small = std::make_shared<const Family>(few, true);
  add("explore/few/two_threads", [=] { run_stored(*small, 2); });
  add("explore/few/one_thread", [=] { run_stored(*small, 1); });
  add("explore/two_threads/uncompressed", [=] { run_stored(*plain, 2); });
  add("explore/two_threads/no_store", [=] { run_without_store(*plain, *plain->source, 2); });
  add("explore/two_threads/given_points", [=] { run_without_store(*plain, *points, 2); });
  add("explore/two_threads/bare_tbb_loop", [=] { run_bare(*plain, 2); });
  add("explore/two_threads/pagmo_thread_bfe", [=] { run_pagmo(*plain, *points, 2); });
}

/// Measured rows, as the store takes them and as SQLite does.
struct Measured {
  explicit Measured(const Family& family) : layout(family.plan->study, family.plan->space) {
    rows = explore::make_rows(layout, 0, table_rows);
    family.source->values(0, table_rows, rows.values);
    explore::VariantEvaluator evaluator(family.plan);
    explore::measure_rows(evaluator, rows);
    const std::size_t values = rows.values.size() / table_rows,
                      more = rows.metrics.size() / table_rows;
    columns = int(values + more) + 3;
    for (std::size_t row = 0; row < table_rows; ++row) {
      flat.insert(flat.end(), &rows.values[row * values], &rows.values[row * values] + values);
      flat.insert(flat.end(), &rows.metrics[row * more], &rows.metrics[row * more] + more);
      flat.insert(flat.end(),
                  {double(rows.status[row]), double(rows.cause[row]), double(rows.seconds[row])});
    }
  }
  explore::StoreLayout layout;
  explore::VariantRows rows;
  int columns = 0;
  std::vector<double> flat;
};

void append_to_store(const Family& family, const Measured& measured) {
  explore::StoreWriter store = new_store(family);
  store.append(measured.rows);
  store.finish();
}

void append_to_sqlite(const Family& family, const Measured& measured, SqliteWay way, int rows) {
  write_sqlite(family.folder.fresh("a.sqlite"), way, measured.columns,
               {measured.flat.data(), std::size_t(rows * measured.columns)});
}

void add_stores(const FamilyPointer& plain, const FamilyPointer& compressed) {
  const auto measured = std::make_shared<Measured>(*plain);
  const auto packed = std::make_shared<Measured>(*compressed);
  add("explore/store/append", [=] { append_to_store(*compressed, *packed); });
  add("explore/store/append/uncompressed", [=] { append_to_store(*plain, *measured); });
  add("explore/store/sqlite_bulk",
      [=] { append_to_sqlite(*plain, *measured, SqliteWay::bulk, table_rows); });
  add("explore/store/sqlite_one_by_one",
      [=] { append_to_sqlite(*plain, *measured, SqliteWay::one_by_one, one_by_one); });
  add("explore/store/sqlite_one_by_one_unsafe",
      [=] { append_to_sqlite(*plain, *measured, SqliteWay::one_by_one_unsafe, table_rows); });
}

}  // namespace

void register_explore_benchmarks() {
  add_runs(std::make_shared<Family>(variants, false), std::make_shared<Family>(variants, true));
  add_stores(std::make_shared<Family>(table_rows, false),
             std::make_shared<Family>(table_rows, true));
}

Report explore_report() {
  const double scale = double(table_rows) / one_by_one;
  Report report;
  report.rates = {
      {"explore: stored variants, two threads", "explore/two_threads", variants, 40000},
      {"explore: the same, uncompressed", "explore/two_threads/uncompressed", variants, 40000},
      {"store: rows appended", "explore/store/append", table_rows, 0},
      {"store: rows appended, uncompressed", "explore/store/append/uncompressed", table_rows, 0}};
  const std::string all = "explore/two_threads", cpu = processor_time, store = "explore/store/";
  report.ratios = {
      {"explore: one thread / two threads, 10,000 variants", "explore/few/one_thread",
       "explore/few/two_threads", 1.8},
      {"explore, time of processors: stored / not stored, compressed", all + cpu,
       all + "/no_store" + cpu, 1.08, true},
      {"explore, time of processors: stored / not stored, uncompressed",
       all + "/uncompressed" + cpu, all + "/no_store" + cpu, 1.03, true},
      {"explore, time of processors: not stored / bare TBB loop", all + "/no_store" + cpu,
       all + "/bare_tbb_loop" + cpu, 1.05, true},
      {"explore, time of processors: given points / pagmo2's thread_bfe",
       all + "/given_points" + cpu, all + "/pagmo_thread_bfe" + cpu, 1.0, true},
      {"explore: stored / not stored, compressed", all, all + "/no_store", 1.08, true},
      {"explore: stored / not stored, uncompressed", all + "/uncompressed", all + "/no_store", 1.03,
       true},
      {"explore: not stored / bare TBB loop", all + "/no_store", all + "/bare_tbb_loop", 1.05,
       true},
      {"explore: given points / pagmo2's thread_bfe", all + "/given_points",
       all + "/pagmo_thread_bfe", 1.0, true},
      {"store: SQLite, a transaction each row / ours", store + "sqlite_one_by_one",
       store + "append", 20.0, false, scale},
      {"store: SQLite, the same without waiting for the disk / ours",
       store + "sqlite_one_by_one_unsafe", store + "append"},
      {"store: SQLite, one transaction / ours", store + "sqlite_bulk", store + "append", 2.0},
      {"store: SQLite, one transaction / ours, uncompressed", store + "sqlite_bulk",
       store + "append/uncompressed", 2.0},
      {"store, time of processors: SQLite, one transaction / ours", store + "sqlite_bulk" + cpu,
       store + "append" + cpu, 2.0},
      {"store, time of processors: SQLite, one transaction / ours, uncompressed",
       store + "sqlite_bulk" + cpu, store + "append/uncompressed" + cpu, 2.0},
  };
  return report;
}

}  // namespace bodyline::bench
