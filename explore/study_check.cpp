#include "explore/study_check.hpp"

#include "explore/design_space.hpp"
#include "explore/metric_slopes.hpp"
#include "explore/optimizer_kind.hpp"
#include "explore/study_error.hpp"
#include "explore/variant_plan.hpp"
#include "explore/variant_source.hpp"
#include "optimize/constrained_search.hpp"

namespace bodyline::explore {

namespace {

void check_gradient(const Study& study, const std::string& metric, const std::string& key) {
  for (const MetricSpec& spec : study.metrics) {
    if (spec.name != metric || has_gradient(spec.kind)) continue;
    throw StudyError(key, "names \"" + metric + "\", and the metric " + metric_name(spec.kind) +
                              " has no gradient, which the optimizer " +
                              optimizer_name(study.optimizer->kind) +
                              " needs; those that have one are " + metrics_with_gradient());
  }
}

void check_optimizer(const Study& study) {
  const OptimizerSpec& optimizer = *study.optimizer;
  if (!uses_gradients(optimizer.kind)) return;
  for (const Goal& goal : optimizer.goals)
    check_gradient(study, goal.metric,
                   goal.weight > 0.0 ? "optimizer.minimize" : "optimizer.maximize");
  for (const Constraint& constraint : study.constraints)
    check_gradient(study, constraint.metric, "constraints." + constraint.metric);
  if (optimizer.kind == OptimizerKind::front && study.base == BaseKind::choice)
    throw StudyError("choice",
                     "jumps from car to car, and a front by gradients needs variables "
                     "that change gradually; \"blend\" does, and nsga2 takes a choice");
  if (optimizer.kind != OptimizerKind::local) return;
  const std::string name = optimize::algorithm_name(optimizer.algorithm);
  if (!study.constraints.empty() && !optimize::keeps_constraints(optimizer.algorithm)) {
    throw StudyError("optimizer.algorithm", "is " + name +
                                                ", which keeps no constraints; nlopt-slsqp, "
                                                "nlopt-mma and nlopt-ccsaq do");
  }
  if (optimizer.algorithm == optimize::Algorithm::ceres_lm)
    throw StudyError("optimizer.algorithm",
                     "is " + name + ", which needs residuals; a study's metrics have none");
}

}  // namespace

void check_study(const Study& study) {
  const DesignSpace space(study);
  check_metrics(study, space);
  source_size(study, space);
  if (study.optimizer) check_optimizer(study);
}

}  // namespace bodyline::explore
