#include "optimize/curve_chain_problem.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "model/propagated.hpp"

namespace bodyline::optimize {
namespace {

// The largest shape parameter that a search may come to.
double most_shape(const model::CurveChain& chain,
                  const std::vector<model::ChainVariable>& variables) {
  double most = 0.0;
  for (const model::FamilyCurve& curve : chain.curves) {
    for (const double shape : curve.shape) most = std::max(most, shape);
  }
  for (const model::ChainVariable& variable : variables) {
    if (variable.kind == model::ChainKind::shape) most = std::max(most, variable.upper);
  }
  return most;
}

}  // namespace

CurveChainProblem::CurveChainProblem(const model::CurveChain& chain,
                                     std::vector<model::ChainVariable> variables,
                                     const CurveChainProblemOptions& options)
    : ChainObjective(std::move(variables),
                     to_numbers(propagated(chain), model::CurveChainLayout(chain)), options.within),
      chain_(propagated(chain)),
      layout_(chain),
      options_(options),
      rule_(model::curve_rule(most_shape(chain, this->variables()))) {}

model::CurveChain CurveChainProblem::chain_at(const Eigen::VectorXd& x) const {
  model::CurveChain chain = chain_;
  set_numbers(chain, layout_, numbers_at(x));
  propagate(chain);
  return chain;
}

double CurveChainProblem::value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  model::CurveChain chain;
  try {
    chain = chain_at(x);
  } catch (const std::invalid_argument&) {
    if (gradient) gradient->setConstant(x.size(), std::numeric_limits<double>::quiet_NaN());
    return std::numeric_limits<double>::quiet_NaN();
  }
  measure_ = 0.0;
  std::vector<model::FamilyCurveBar> bars;
  for (const model::FamilyCurve& curve : chain.curves) {
    measure_ += gradient ? model::fairness_pullback(curve, options_.measure, rule_, 1.0,
                                                    bars.emplace_back(curve))
                         : model::fairness(curve, options_.measure, rule_);
  }
  if (gradient) *gradient = numbers_at_pullback(propagate_pullback(chain, layout_, bars));
  return measure_;
}

}  // namespace bodyline::optimize
