#include "explore/variant_recorder.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "explore/measure_rows.hpp"
#include "explore/thread_count.hpp"

namespace bodyline::explore {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int task_rows = 4;  // measured by one thread at a time
// Variants wait no longer to be written.
constexpr std::chrono::seconds longest_wait{10};

}  // namespace

struct VariantRecorder::State {
  State(std::shared_ptr<const VariantPlan> of, StoreWriter& writer, const StoreReader& reader,
        std::uint64_t planned, const RunOptions& given)
      : plan(std::move(of)),
        store(writer),
        begun(reader),
        options(given),
        arena(thread_count(given.threads)),
        evaluators([this] { return VariantEvaluator(plan); }) {
    progress.planned = planned;
  }

  VariantRows measure(std::span<const double> values, int count);
  void check_known(const VariantRows& rows, std::span<const double> values) const;
  void append(const VariantRows& rows);
  void report();

  std::shared_ptr<const VariantPlan> plan;
  StoreWriter& store;
  const StoreReader& begun;
  const RunOptions& options;
  tbb::task_arena arena;
  tbb::enumerable_thread_specific<VariantEvaluator> evaluators;
  std::uint64_t next = 0;
  RunProgress progress;
  Clock::time_point start = Clock::now(), written = start;
};

VariantRows VariantRecorder::State::measure(std::span<const double> values, int count) {
  const StoreLayout& layout = store.layout();
  VariantRows rows = make_rows(layout, next, count);
  std::copy(values.begin(), values.end(), rows.values.begin());
  const int tasks = (count + task_rows - 1) / task_rows;
  arena.execute([&] {
    tbb::parallel_for(0, tasks, [&](int task) {
      const int first = task * task_rows, part = std::min(task_rows, count - first);
      VariantRows some = make_rows(layout, next + std::uint64_t(first), part);
      copy_rows(layout, rows, first, some, 0, part);
      measure_rows(evaluators.local(), some);
      copy_rows(layout, some, 0, rows, first, part);
    });
  });
  return rows;
}

void VariantRecorder::State::check_known(const VariantRows& rows,
                                         std::span<const double> values) const {
  if (std::memcmp(rows.values.data(), values.data(), rows.values.size() * sizeof(double)) == 0)
    return;
  throw StoreError(begun.path(),
                   "has other variants than the optimizer asks for now; was it begun on another "
                   "kind of processor?");
}

void VariantRecorder::State::append(const VariantRows& rows) {
  store.append(rows);
  count_rows(rows, plan->study.metrics.size(), progress);
  if (Clock::now() - written < longest_wait) return;
  written = Clock::now();
  store.flush();
}

void VariantRecorder::State::report() {
  progress.done = next;
  progress.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (options.on_progress) options.on_progress(progress);
}

VariantRecorder::VariantRecorder(std::shared_ptr<const VariantPlan> plan, StoreWriter& store,
                                 const StoreReader& begun, std::uint64_t planned,
                                 const RunOptions& options)
    : state_(std::make_unique<State>(std::move(plan), store, begun, planned, options)) {}
VariantRecorder::~VariantRecorder() = default;

std::uint64_t VariantRecorder::known_rows() const {
  return state_->begun.rows() - std::min(state_->begun.rows(), state_->next);
}

VariantRows VariantRecorder::take_known(int count) {
  VariantRows rows = state_->begun.read(state_->next, count);
  state_->next += std::uint64_t(count);
  return rows;
}

VariantRows VariantRecorder::record(std::span<const double> values) {
  State& state = *state_;
  const std::size_t columns = std::size_t(state.plan->space.column_count());
  const int count = int(values.size() / columns);
  const int known = int(std::min<std::uint64_t>(known_rows(), std::uint64_t(count)));
  VariantRows all = make_rows(state.store.layout(), state.next, count);
  if (known > 0) {
    const VariantRows rows = state.begun.read(state.next, known, true);
    state.check_known(rows, values.first(std::size_t(known) * columns));
    copy_rows(state.store.layout(), rows, 0, all, 0, known);
    state.next += std::uint64_t(known);
  }
  if (count > known) {
    const VariantRows rows =
        state.measure(values.subspan(std::size_t(known) * columns), count - known);
    copy_rows(state.store.layout(), rows, 0, all, known, count - known);
    state.append(rows);
    state.next += std::uint64_t(count - known);
  }
  state.report();
  return all;
}

const VariantPlan& VariantRecorder::plan() const { return *state_->plan; }
const RunOptions& VariantRecorder::options() const { return state_->options; }
bool VariantRecorder::should_stop() const {
  return state_->options.should_stop && state_->options.should_stop();
}
void VariantRecorder::set_note(const std::string& note) { state_->progress.note = note; }
void VariantRecorder::count_evaluations(std::uint64_t evaluations) {
  state_->progress.evaluations += evaluations;
}

RunProgress VariantRecorder::progress() {
  state_->report();
  return state_->progress;
}

}  // namespace bodyline::explore
