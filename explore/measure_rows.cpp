#include "explore/measure_rows.hpp"

#include <algorithm>
#include <chrono>

#include "explore/thumbnail.hpp"

namespace bodyline::explore {
namespace {

using Clock = std::chrono::steady_clock;

bool is_built(VariantStatus status) {
  return status != VariantStatus::cut_order && status != VariantStatus::fullness &&
         status != VariantStatus::lean;
}

// Row `row` of an array with so many rows.
template <class Value>
std::span<Value> row_of(std::vector<Value>& values, int rows, int row) {
  const std::size_t size = values.size() / std::size_t(rows);
  return {values.data() + std::size_t(row) * size, size};
}

}  // namespace

void measure_rows(VariantEvaluator& evaluator, VariantRows& rows) {
  const Study& study = evaluator.plan().study;
  Clock::time_point before = Clock::now();
  for (int row = 0; row < rows.count; ++row) {
    const VariantOutcome outcome = evaluator.measure(row_of(rows.values, rows.count, row),
                                                     row_of(rows.metrics, rows.count, row));
    rows.status[row] = std::uint8_t(outcome.status);
    rows.cause[row] = outcome.cause;
    if (is_built(outcome.status) && study.keep.nets) {
      const std::span<const double> nets = evaluator.nets();
      std::transform(nets.begin(), nets.end(), row_of(rows.nets, rows.count, row).begin(),
                     [](double x) { return float(x); });
    }
    if (is_built(outcome.status) && study.keep.thumbnail_width > 0) {
      draw_thumbnail(evaluator.plan().space.context()->plan, evaluator.nets().data(),
                     study.keep.thumbnail_width, row_of(rows.thumbnails, rows.count, row));
    }
    const Clock::time_point now = Clock::now();
    rows.seconds[row] = std::chrono::duration<float>(now - before).count();
    before = now;
  }
}

std::shared_ptr<VariantRows> measure_range(VariantEvaluator& evaluator, const StoreLayout& layout,
                                           const VariantSource& source, std::uint64_t first,
                                           int count) {
  auto rows = std::make_shared<VariantRows>(make_rows(layout, first, count));
  source.values(first, count, rows->values);
  measure_rows(evaluator, *rows);
  return rows;
}

}  // namespace bodyline::explore
