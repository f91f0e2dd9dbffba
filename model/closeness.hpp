#pragma once

#include <vector>

#include "model/body_plan.hpp"
#include "model/net_term.hpp"

namespace bodyline::model {

/// Mean squared distance of the points of the base nets from where they were, mm^2.
class Closeness : public NetTerm {
 public:
  /// `nets` are those to stay close to, xyz at the plan's offsets.
  Closeness(const BodyPlan& plan, const double* nets);

  Stage stage() const override { return Stage::base; }
  double value(const double* nets, double scale, double* nets_bar) override;
  Eigen::Index residual_count() const override { return Eigen::Index(start_.size()); }
  void residuals(const double* nets, Eigen::Ref<Eigen::VectorXd> r, Jacobian* jacobian) override;

 private:
  std::vector<double> start_;  // of the base nets, which come first
  double points_;              // how many
  Eigen::Index columns_;       // numbers in all nets
};

}  // namespace bodyline::model
