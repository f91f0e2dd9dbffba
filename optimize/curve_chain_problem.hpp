#pragma once

#include <vector>

#include "model/curve_chain.hpp"
#include "model/curve_chain_numbers.hpp"
#include "model/curve_fairness.hpp"
#include "optimize/chain_objective.hpp"

namespace bodyline::optimize {

struct CurveChainProblemOptions {
  model::CurveFairness measure = model::CurveFairness::bending;  ///< summed over all curves
  double within = 10.0;  ///< how far each coordinate of a free control point may move, mm; positive
};

/// Fairness of a chain of joined curves over some of its variables. The points that the joins
/// determine are computed again for every x, so that the joins hold exactly throughout.
class CurveChainProblem : public ChainObjective {
 public:
  /// Throws std::invalid_argument as model::propagate.
  CurveChainProblem(const model::CurveChain& chain, std::vector<model::ChainVariable> variables,
                    const CurveChainProblemOptions& options);

  /// Not finite where shape parameters leave a point undefined or a curve stands still.
  double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) override;
  /// The propagated chain at x. Throws as model::propagate.
  model::CurveChain chain_at(const Eigen::VectorXd& x) const;
  double measure() const override { return measure_; }

 private:
  model::CurveChain chain_;
  model::CurveChainLayout layout_;
  CurveChainProblemOptions options_;
  model::GaussRule rule_;
  double measure_ = 0.0;
};

}  // namespace bodyline::optimize
