#include "explore/row_crew.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>

#include "explore/measure_rows.hpp"
#include "explore/variant_evaluator.hpp"

namespace bodyline::explore {

struct RowCrew::State {
  State(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& of,
        const StoreLayout& to, int count)
      : source(of),
        layout(to),
        threads(count),
        limit(tbb::global_control::max_allowed_parallelism, std::size_t(count) + 1),
        arena(count, 0),
        evaluators([plan] { return VariantEvaluator(plan); }) {}

  void measure(std::uint64_t first, int count) {
    try {
      if (dropped) return;
      auto rows = measure_range(evaluators.local(), layout, source, first, count);
      const std::lock_guard lock(mutex);
      done.push_back(std::move(rows));
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
    }
    wake.notify_one();
  }

  const VariantSource& source;
  StoreLayout layout;
  int threads;
  tbb::global_control limit;  // the caller's thread takes no part
  tbb::task_arena arena;
  tbb::enumerable_thread_specific<VariantEvaluator> evaluators;
  tbb::task_group group;
  std::atomic<bool> dropped{false};

  std::mutex mutex;  // guards what follows
  std::condition_variable wake;
  std::deque<std::shared_ptr<VariantRows>> done;
  std::exception_ptr failure;
};

RowCrew::RowCrew(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& source,
                 const StoreLayout& layout, int threads)
    : state_(std::make_unique<State>(plan, source, layout, threads)) {}

RowCrew::~RowCrew() {
  drop();
  state_->arena.execute([&] { state_->group.wait(); });
}

void RowCrew::drop() { state_->dropped = true; }

int RowCrew::threads() const { return state_->threads; }

void RowCrew::measure(std::uint64_t first, int count) {
  State& state = *state_;
  state.arena.enqueue(state.group.defer([&state, first, count] { state.measure(first, count); }));
}

std::shared_ptr<VariantRows> RowCrew::collect(std::chrono::microseconds wait) {
  State& state = *state_;
  std::unique_lock lock(state.mutex);
  state.wake.wait_for(lock, wait, [&] { return !state.done.empty() || state.failure; });
  if (state.failure) std::rethrow_exception(state.failure);
  if (state.done.empty()) return nullptr;
  std::shared_ptr<VariantRows> rows = std::move(state.done.front());
  state.done.pop_front();
  return rows;
}

std::future<std::shared_ptr<EncodedBlock>> RowCrew::encode(std::shared_ptr<VariantRows> block) {
  State& state = *state_;
  const auto task = std::make_shared<std::packaged_task<std::shared_ptr<EncodedBlock>()>>(
      [&state, block = std::move(block)] {
        return std::make_shared<EncodedBlock>(encode_block(state.layout, *block));
      });
  state.arena.enqueue(state.group.defer([task] { (*task)(); }));
  return task->get_future();
}

}  // namespace bodyline::explore
