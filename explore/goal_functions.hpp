#pragma once

#include "explore/metric_slopes.hpp"
#include "optimize/smooth_functions.hpp"

namespace bodyline::explore {

/// The goals of a study's optimizer, to be small, and after them its constraints, kept where they
/// are at most 0: what searches by gradients see. One per thread.
class GoalFunctions : public optimize::SmoothFunctions {
 public:
  enum class Goals {
    each,   ///< a function each, times the sign of its weight
    summed  ///< one function, their weighted sum
  };
  GoalFunctions(std::shared_ptr<const VariantPlan> plan, Goals goals);

  const SearchSpace& space() const { return slopes_.space(); }
  int goal_count() const { return goals_; }
  int size() const override { return slopes_.space().size(); }
  int count() const override { return int(combination_.rows()); }
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& values,
                Eigen::MatrixXd& jacobian) override;

 private:
  MetricSlopes slopes_;
  int goals_ = 0;
  Eigen::MatrixXd combination_;  // functions = combination * metrics + offset
  Eigen::VectorXd offset_, metrics_;
  Eigen::MatrixXd metric_jacobian_;
};

/// What the goals of one variant with these metrics (of the study, in their order) come to, each
/// times its weight.
std::vector<double> goal_values(const Study& study, std::span<const double> metrics);

/// By how much metrics break the constraints, in sizes of their bounds, summed up.
double broken_constraints(const Study& study, std::span<const double> metrics);

}  // namespace bodyline::explore
