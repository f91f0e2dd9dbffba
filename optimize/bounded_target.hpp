#pragma once

#include <memory>
#include <vector>

#include "optimize/fit_target.hpp"
#include "optimize/net_rows.hpp"

namespace bodyline::optimize {

/// Quantities of a body that a fit keeps within bounds, by the method of multipliers: what a round
/// leaves over shifts the bounds of the next. So they hold to any accuracy in the end although no
/// weight is large.
class BoundedTarget : public FitTarget {
 public:
  void match(const double* nets, const FitRound& round) override;
  /// What the body is out of its bounds moves the multipliers.
  void advance() override;
  model::WeightedNetTerm term() const override { return {term_, 1.0}; }
  double excess() const override { return excess_; }

 protected:
  BoundedTarget(const model::BodyPlan& plan, model::Stage stage)
      : term_(std::make_shared<NetRows>(plan, stage)) {}
  /// The quantities at the nets, with their derivatives; always the same ones in the same order.
  virtual std::vector<NetRow> measure(const double* nets) = 0;

 private:
  std::shared_ptr<NetRows> term_;
  void shift_rows();

  std::vector<NetRow> rows_;    // as of the last match
  std::vector<double> values_;  // of the rows there
  std::vector<double> shifts_;  // the multipliers, mm
  double excess_ = 0.0;
};

}  // namespace bodyline::optimize
