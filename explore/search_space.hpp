#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "explore/design_space.hpp"

namespace bodyline::explore {

/// The cube that searches by gradients move in: a design space whose variables are smooth functions
/// of coordinates in [0, 1]. A coordinate is a variable's place in its range; of a blend, the share
/// that a model takes of what those before it left, so that weights are products of coordinates. A
/// choice stays as it is. The design space must outlive it.
class SearchSpace {
 public:
  explicit SearchSpace(const DesignSpace& space);

  int size() const { return space_->dimension(); }

  /// The values at a point, one per column, not rounded.
  void values(const Eigen::VectorXd& point, std::span<double> values) const;
  /// Adjoint of `values`.
  void pullback(const Eigen::VectorXd& point, std::span<const double> values_bar,
                Eigen::Ref<Eigen::VectorXd> point_bar) const;

  /// An inverse of `values`.
  Eigen::VectorXd point(std::span<const double> values) const;
  /// The values at a point as a store holds them.
  std::vector<double> rounded(const Eigen::VectorXd& point) const;

 private:
  const DesignSpace* space_;
  int weights_ = 0;  // columns, the first ones
};

}  // namespace bodyline::explore
