#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "model/body_plan.hpp"
#include "model/net_term.hpp"

namespace bodyline::optimize {

/// A quantity that is linear in the numbers of the nets, and the interval where it should lie.
struct NetRow {
  std::vector<std::pair<int, double>> slopes;  ///< index of a number, derivative by it
  double offset = 0.0;                         ///< the quantity is offset + sum of slope * number
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  double at(const double* nets) const;
  /// How far a value lies above the interval, below it when negative, 0 inside.
  double excess(double value) const;
};

/// Sum of the squared excesses of rows.
class NetRows : public model::NetTerm {
 public:
  NetRows(const model::BodyPlan& plan, model::Stage stage);

  void set(std::vector<NetRow> rows) { rows_ = std::move(rows); }

  model::Stage stage() const override { return stage_; }
  double value(const double* nets, double scale, double* nets_bar) override;
  Eigen::Index residual_count() const override { return Eigen::Index(rows_.size()); }
  void residuals(const double* nets, Eigen::Ref<Eigen::VectorXd> r, Jacobian* jacobian) override;

 private:
  model::Stage stage_;
  Eigen::Index columns_;
  std::vector<NetRow> rows_;
};

}  // namespace bodyline::optimize
