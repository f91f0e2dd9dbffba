#include "explore/goal_functions.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::explore {
namespace {

// Constraints are kept so much inside, in sizes of their bounds, that rounding does not break them.
constexpr double margin = 1e-7;
constexpr double least_size = 1e-3;

int metric_index(const Study& study, const std::string& name) {
  const auto found = std::find_if(study.metrics.begin(), study.metrics.end(),
                                  [&](const MetricSpec& metric) { return metric.name == name; });
  return int(found - study.metrics.begin());
}

double size_of(double bound) { return std::max(std::abs(bound), least_size); }

// The metrics that goals and constraints name: goals first, one entry each.
std::vector<int> named_metrics(const Study& study) {
  std::vector<int> metrics;
  for (const Goal& goal : study.optimizer->goals)
    metrics.push_back(metric_index(study, goal.metric));
  for (const Constraint& constraint : study.constraints)
    metrics.push_back(metric_index(study, constraint.metric));
  return metrics;
}

}  // namespace

GoalFunctions::GoalFunctions(std::shared_ptr<const VariantPlan> plan, Goals goals)
    : slopes_(plan, named_metrics(plan->study)) {
  const Study& study = plan->study;
  const std::vector<Goal>& list = study.optimizer->goals;
  goals_ = goals == Goals::summed ? 1 : int(list.size());
  int sides = 0;
  for (const Constraint& constraint : study.constraints)
    sides += int(std::isfinite(constraint.least)) + int(std::isfinite(constraint.most));
  combination_.setZero(goals_ + sides, slopes_.count());
  offset_.setZero(goals_ + sides);
  for (int k = 0; k < int(list.size()); ++k)
    combination_(goals == Goals::summed ? 0 : k, k) = list[k].weight;
  int row = goals_, column = int(list.size());
  for (const Constraint& constraint : study.constraints) {
    const auto add = [&](double bound, double sign) {
      if (!std::isfinite(bound)) return;
      combination_(row, column) = sign / size_of(bound);
      offset_[row] = margin - sign * bound / size_of(bound);
      ++row;
    };
    add(constraint.most, 1.0);
    add(constraint.least, -1.0);
    ++column;
  }
}

bool GoalFunctions::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& values,
                             Eigen::MatrixXd& jacobian) {
  if (!slopes_.evaluate(x, metrics_, metric_jacobian_)) return false;
  values.noalias() = combination_ * metrics_;
  values += offset_;
  jacobian.noalias() = combination_ * metric_jacobian_;
  return true;
}

std::vector<double> goal_values(const Study& study, std::span<const double> metrics) {
  std::vector<double> values;
  for (const Goal& goal : study.optimizer->goals)
    values.push_back(goal.weight * metrics[metric_index(study, goal.metric)]);
  return values;
}

double broken_constraints(const Study& study, std::span<const double> metrics) {
  double broken = 0.0;
  for (const Constraint& constraint : study.constraints) {
    const double value = metrics[metric_index(study, constraint.metric)];
    if (value > constraint.most) broken += (value - constraint.most) / size_of(constraint.most);
    if (value < constraint.least) broken += (constraint.least - value) / size_of(constraint.least);
  }
  return broken;
}

}  // namespace bodyline::explore
