#pragma once

#include <Eigen/Core>
#include <memory>

#include "model/evaluator.hpp"

namespace bodyline::optimize {

/// An evaluator's objective as a sum of squares: the energies node by node, compressed face by face
/// with a QR decomposition to as many rows as the face's net has coordinates; every other term as
/// one square root. The rows carry the same cost, gradient and Gauss-Newton matrix as the full
/// residuals.
class EnergyResiduals {
 public:
  /// Throws std::invalid_argument when a term has a negative weight.
  explicit EnergyResiduals(model::Evaluator& evaluator);
  ~EnergyResiduals();

  Eigen::Index count() const;
  /// residual has count() entries, jacobian (may be null) count() by evaluator.size().
  void evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residual, Eigen::MatrixXd* jacobian);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::optimize
