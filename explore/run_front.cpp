#include "explore/run_front.hpp"

#include <fmt/format.h>

#include "explore/find_points.hpp"
#include "explore/goal_functions.hpp"
#include "explore/trace_front.hpp"

namespace bodyline::explore {
namespace {

FrontPoint point_of(const VariantPlan& plan, const SearchSpace& space, const VariantRows& rows,
                    std::size_t row) {
  const std::size_t columns = std::size_t(plan.space.column_count()),
                    metrics = plan.study.metrics.size();
  FrontPoint point;
  point.usable = rows.status[row] == std::uint8_t(VariantStatus::valid);
  point.x = space.point(std::span(rows.values).subspan(row * columns, columns));
  const std::vector<double> goals =
      goal_values(plan.study, std::span(rows.metrics).subspan(row * metrics, metrics));
  point.values = {goals[0], goals[1]};
  return point;
}

}  // namespace

RunProgress run_front(const std::shared_ptr<const VariantPlan>& plan, VariantRecorder& recorder) {
  const OptimizerSpec& spec = *plan->study.optimizer;
  const SearchSpace space(plan->space);
  PointFinder finder(
      [plan] { return std::make_unique<GoalFunctions>(plan, GoalFunctions::Goals::each); },
      spec.evaluations, recorder.options());
  std::size_t found = 0;
  const auto find = [&](const std::vector<FrontTask>& tasks) {
    // What the store has is not searched again.
    const std::size_t known = std::min<std::size_t>(tasks.size(), recorder.known_rows());
    std::vector<FrontPoint> points;
    const auto take = [&](const VariantRows& rows) {
      for (std::size_t row = 0; row < std::size_t(rows.count); ++row)
        points.push_back(point_of(*plan, space, rows, row));
      found += std::size_t(rows.count);
    };
    if (known > 0) take(recorder.take_known(int(known)));
    recorder.set_note(fmt::format("{} points on the front", found));
    if (known == tasks.size()) return points;
    const PointFinder::Found round =
        finder.find({tasks.begin() + std::ptrdiff_t(known), tasks.end()});
    recorder.count_evaluations(round.evaluations);
    if (!round.complete) return points;
    std::vector<double> values;
    for (const Eigen::VectorXd& x : round.points) {
      const std::vector<double> row = space.rounded(x);
      values.insert(values.end(), row.begin(), row.end());
    }
    take(recorder.record(values));
    return points;
  };
  trace_front(space.point(plan->space.start_values()), spec.points, find);
  RunProgress progress = recorder.progress();
  if (!recorder.should_stop()) progress.planned = progress.done;
  return progress;
}

}  // namespace bodyline::explore
