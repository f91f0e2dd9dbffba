#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "explore/body_rules.hpp"
#include "explore/search_space.hpp"
#include "explore/variant_plan.hpp"
#include "model/selection.hpp"

namespace bodyline::explore {

/// Whether a metric has a gradient: the terms of an objective and the dimensions do.
bool has_gradient(MetricKind kind);
/// "bending, variation, ...": all that have one.
std::string metrics_with_gradient();

/// Metrics of a study and their exact gradients by the coordinates of the search space. One per
/// thread.
class MetricSlopes {
 public:
  /// `metrics` are indices into the study's, each with a gradient.
  MetricSlopes(std::shared_ptr<const VariantPlan> plan, const std::vector<int>& metrics);

  const SearchSpace& space() const { return space_; }
  int count() const { return int(evaluators_.size()); }

  /// Values, and the Jacobian (count() by the size of the space), at a point. False where the body
  /// cannot be built or a number is not finite.
  bool evaluate(const Eigen::VectorXd& point, Eigen::VectorXd& values, Eigen::MatrixXd& jacobian);

 private:
  std::shared_ptr<const VariantPlan> plan_;
  SearchSpace space_;
  BodyRules rules_;
  model::Selection selection_;
  std::vector<model::Evaluator> evaluators_;  // of each metric
  std::vector<double> columns_, columns_bar_;
  Eigen::VectorXd x_, x_bar_, parameters_, slope_;
};

}  // namespace bodyline::explore
