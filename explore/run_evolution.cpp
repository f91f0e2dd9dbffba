#include "explore/run_evolution.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "explore/evolution.hpp"
#include "explore/goal_functions.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {
namespace {

// Above all objectives; times 1 to 2 where a constraint is broken, by how much.
constexpr double penalty = 1e30;
constexpr double folded_penalty = 2.0 * penalty, unbuilt_penalty = 3.0 * penalty;

class StudyObjectives : public ObjectiveBatch {
 public:
  explicit StudyObjectives(VariantRecorder& recorder)
      : recorder_(recorder), plan_(recorder.plan()) {}

  int dimension() const override { return plan_.space.dimension(); }
  int objectives() const override { return int(plan_.study.optimizer->goals.size()); }

  void evaluate(std::span<const double> points, std::span<double> values) override {
    const std::size_t d = std::size_t(dimension()), count = points.size() / d;
    const std::size_t columns = std::size_t(plan_.space.column_count()),
                      m = std::size_t(objectives()), all = plan_.study.metrics.size();
    std::vector<double> rows(count * columns);
    for (std::size_t k = 0; k < count; ++k)
      plan_.space.values(points.subspan(k * d, d), std::span(rows).subspan(k * columns, columns));
    const VariantRows measured = recorder_.record(rows);
    for (std::size_t k = 0; k < count; ++k) {
      judge(VariantStatus(measured.status[k]), std::span(measured.metrics).subspan(k * all, all),
            values.subspan(k * m, m));
    }
  }

 private:
  void judge(VariantStatus status, std::span<const double> metrics, std::span<double> values) {
    switch (status) {
      case VariantStatus::valid: {
        const std::vector<double> goals = goal_values(plan_.study, metrics);
        std::copy(goals.begin(), goals.end(), values.begin());
        return;
      }
      case VariantStatus::infeasible: {
        const double broken = broken_constraints(plan_.study, metrics);
        std::fill(values.begin(), values.end(), penalty * (1.0 + broken / (1.0 + broken)));
        return;
      }
      case VariantStatus::folded:
        std::fill(values.begin(), values.end(), folded_penalty);
        return;
      default:
        std::fill(values.begin(), values.end(), unbuilt_penalty);
    }
  }

  VariantRecorder& recorder_;
  const VariantPlan& plan_;
};

std::vector<double> first_points(const VariantPlan& plan) {
  const std::size_t d = std::size_t(plan.space.dimension()),
                    columns = std::size_t(plan.space.column_count());
  const auto count = std::size_t(plan.study.optimizer->population);
  std::vector<double> points = plan.space.start_point(), values(columns);
  points.resize(count * d);
  const auto source = make_source(plan.study, plan.space);
  for (std::size_t k = 1; k < count; ++k) {
    source->values(k - 1, 1, values);
    plan.space.point(values, std::span(points).subspan(k * d, d));
  }
  return points;
}

}  // namespace

RunProgress run_evolution(VariantRecorder& recorder) {
  const VariantPlan& plan = recorder.plan();
  const OptimizerSpec& spec = *plan.study.optimizer;
  StudyObjectives objectives(recorder);
  EvolutionOptions options;
  options.generations = spec.generations;
  options.seed = std::uint32_t(spec.seed);
  options.first = first_points(plan);
  options.before = [&](int generation) {
    recorder.set_note(fmt::format("generation {} of {}", generation, spec.generations));
    return !recorder.should_stop();
  };
  if (spec.kind == OptimizerKind::nsga2) {
    evolve_nsga2(objectives, options);
  } else {
    evolve_moead(objectives, options);
  }
  return recorder.progress();
}

}  // namespace bodyline::explore
