#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "model/surface.hpp"

namespace bodyline::model {

/// A term of an objective that looks at the nets of the whole body instead of at the jets of single
/// faces: closeness to another body, the distance to a scan or an outline, a dimension. An
/// Evaluator adds it to the terms that it integrates itself. Nets are xyz at the offsets of the
/// BodyPlan, 3 * point_count numbers.
class NetTerm {
 public:
  virtual ~NetTerm() = default;

  /// How far the body must be built for it.
  virtual Stage stage() const = 0;

  /// The value; adds scale * d value / d nets to `nets_bar` when that is not null.
  virtual double value(const double* nets, double scale, double* nets_bar) = 0;

  /// Least-squares form: sum of squares of residuals(nets) == value(nets), which is never negative.
  /// `jacobian`, when not null, becomes residual_count() by 3 * point_count.
  using Jacobian = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  virtual Eigen::Index residual_count() const = 0;
  virtual void residuals(const double* nets, Eigen::Ref<Eigen::VectorXd> r, Jacobian* jacobian) = 0;
};

/// A term and its weight in an objective. The term is used by one evaluator at a time.
struct WeightedNetTerm {
  std::shared_ptr<NetTerm> term;
  double weight = 1.0;
};

}  // namespace bodyline::model
