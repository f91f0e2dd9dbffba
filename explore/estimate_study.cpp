#include "explore/estimate_study.hpp"

#include <algorithm>
#include <chrono>

#include "explore/block_codec.hpp"
#include "explore/goal_functions.hpp"
#include "explore/measure_rows.hpp"
#include "explore/optimizer_kind.hpp"
#include "optimize/constrained_search.hpp"

namespace bodyline::explore {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds timed_for{50};
constexpr int tried_evaluations = 20;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// The longest that a search by gradients may take for a row, by the beginnings of a few.
double seconds_of_search(const std::shared_ptr<const VariantPlan>& plan, const VariantRows& rows) {
  const auto& optimizer = plan->study.optimizer;
  if (!optimizer || !uses_gradients(optimizer->kind)) return 0.0;
  GoalFunctions functions(plan, GoalFunctions::Goals::each);
  optimize::ConstrainedSearch search;
  for (int k = 0; k < functions.goal_count(); ++k) search.aims.push_back({k});
  search.first_constraint = functions.goal_count();
  search.max_evaluations = std::min(optimizer->evaluations, tried_evaluations);
  const std::size_t columns = std::size_t(plan->space.column_count());
  const Clock::time_point begin = Clock::now();
  int evaluations = 0;
  for (std::size_t row = 0; row < std::size_t(rows.count); ++row) {
    const auto values = std::span(rows.values).subspan(row * columns, columns);
    evaluations += optimize::search_constrained(functions, functions.space().point(values), search)
                       .evaluations;
  }
  return optimizer->evaluations * seconds_since(begin) / evaluations;
}

}  // namespace

StudyEstimate estimate_study(const std::shared_ptr<const VariantPlan>& plan) {
  StudyEstimate estimate;
  const auto starts = make_source(plan->study, plan->space);
  const VariantSource& source = *starts;
  estimate.variants = source.size();
  const StoreLayout layout(plan->study, plan->space);
  VariantRows& rows = estimate.tried;
  rows = make_rows(layout, 0, int(std::min<std::uint64_t>(3, source.size())));
  const std::size_t columns = std::size_t(plan->space.column_count());
  for (int row = 0; row < rows.count; ++row) {
    const std::uint64_t index =
        rows.count < 2 ? 0
                       : std::uint64_t(row) * (source.size() - 1) / std::uint64_t(rows.count - 1);
    source.values(index, 1, {rows.values.data() + std::size_t(row) * columns, columns});
  }
  VariantEvaluator evaluator(plan);
  measure_rows(evaluator, rows);
  const Clock::time_point begin = Clock::now();
  int times = 0;
  do {
    measure_rows(evaluator, rows);
    ++times;
  } while (Clock::now() - begin < timed_for);
  estimate.seconds_per_variant =
      seconds_since(begin) / (times * rows.count) + seconds_of_search(plan, rows);

  // How far a block compresses, seen on one whose metrics are those of the three.
  VariantRows block = make_rows(
      layout, 0, int(std::min<std::uint64_t>(std::uint64_t(layout.block_rows), source.size())));
  for (int row = 0; row < block.count; ++row)
    copy_rows(layout, rows, row % rows.count, block, row, 1);
  source.values(0, block.count, block.values);
  for (const auto& chunks : encode_block(layout, block).chunks) {
    for (const auto& chunk : chunks) estimate.bytes_per_variant += double(chunk.size());
  }
  estimate.bytes_per_variant /= block.count;
  return estimate;
}

}  // namespace bodyline::explore
