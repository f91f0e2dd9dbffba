#include "explore/run_optimizer.hpp"

#include "explore/optimizer_kind.hpp"
#include "explore/run_evolution.hpp"
#include "explore/run_front.hpp"

namespace bodyline::explore {

bool chooses_by_results(const Study& study) {
  return study.optimizer && study.optimizer->kind != OptimizerKind::local;
}

std::uint64_t planned_rows(const std::shared_ptr<const VariantPlan>& plan) {
  return source_size(plan->study, plan->space);
}

RunProgress run_optimizer(const std::shared_ptr<const VariantPlan>& plan, StoreWriter& store,
                          const StoreReader& begun, const RunOptions& options) {
  VariantRecorder recorder(plan, store, begun, planned_rows(plan), options);
  if (plan->study.optimizer->kind == OptimizerKind::front) return run_front(plan, recorder);
  return run_evolution(recorder);
}

}  // namespace bodyline::explore
