#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/curve_chain.hpp"

namespace bodyline::model {

/// Where each number of a chain of curves lies in one flat vector: points, shape parameters, joins.
class CurveChainLayout {
 public:
  explicit CurveChainLayout(const CurveChain& chain);
  int size() const { return size_; }
  /// First of the three coordinates of a control point.
  int point(int curve, int index) const { return curves_[curve].points + 3 * index; }
  int shape(int curve, int index) const { return curves_[curve].shape + index; }
  int ratio(int join) const { return joins_ + 2 * join; }
  int slide(int join) const { return joins_ + 2 * join + 1; }

 private:
  struct Offsets {
    int points, shape;
  };
  std::vector<Offsets> curves_;
  int joins_ = 0, size_ = 0;
};

Eigen::VectorXd to_numbers(const CurveChain& chain, const CurveChainLayout& layout);
void set_numbers(CurveChain& chain, const CurveChainLayout& layout, const Eigen::VectorXd& numbers);

/// Adjoints of all numbers of a propagated chain from those of its curves (consumed): what the
/// joins determined passes its adjoint on, curve after curve, and has none of its own.
Eigen::VectorXd propagate_pullback(const CurveChain& chain, const CurveChainLayout& layout,
                                   std::vector<FamilyCurveBar>& bars);

}  // namespace bodyline::model
