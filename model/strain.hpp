#pragma once

#include <vector>

#include "model/body_plan.hpp"
#include "model/net_term.hpp"

namespace bodyline::model {

/// How much a body is deformed against another: the mean, over the legs between neighbours in its
/// base nets, of |change of the leg|^2 / |leg|^2. No unit. Moves of a body as a whole cost nothing,
/// and short legs resist what would fold a patch at its corner.
class Strain : public NetTerm {
 public:
  /// `nets` are those to be like, xyz at the plan's offsets.
  Strain(const BodyPlan& plan, const double* nets);

  Stage stage() const override { return Stage::base; }
  double value(const double* nets, double scale, double* nets_bar) override;
  Eigen::Index residual_count() const override { return 3 * Eigen::Index(legs_.size()); }
  void residuals(const double* nets, Eigen::Ref<Eigen::VectorXd> r, Jacobian* jacobian) override;

 private:
  struct Leg {
    int from = 0, to = 0;  // numbers of the points' x
    Eigen::Vector3d start;
    double weight = 0.0;  // its square is that of |change|^2
  };
  std::vector<Leg> legs_;
  Eigen::Index columns_;  // numbers in all nets
};

}  // namespace bodyline::model
