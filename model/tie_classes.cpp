#include "model/tie_classes.hpp"

#include <numeric>

namespace bodyline::model {

TieClasses::TieClasses(int count) : parent_(count), factor_(count, 1.0), fixed_(count, 0) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

TieClasses::Place TieClasses::place(int member) const {
  Place result{member, 1.0, false};
  while (parent_[result.root] != result.root) {
    result.factor *= factor_[result.root];
    result.root = parent_[result.root];
  }
  result.fixed = fixed_[result.root] != 0;
  return result;
}

void TieClasses::tie(int a, int b, double factor) {
  const Place pa = place(a), pb = place(b);
  // b = factor * a, a = pa.factor * ra, b = pb.factor * rb
  const double between = pb.factor * factor * pa.factor;  // rb = between * ra
  if (pa.root == pb.root) {
    if (between < 0.0) fixed_[pa.root] = 1;  // its own opposite: a coordinate in the symmetry plane
    return;
  }
  const int low = pa.root < pb.root ? pa.root : pb.root,
            high = pa.root < pb.root ? pb.root : pa.root;
  parent_[high] = low;
  factor_[high] = between;
  if (fixed_[high]) fixed_[low] = 1;
}

void TieClasses::fix(int member) { fixed_[place(member).root] = 1; }

}  // namespace bodyline::model
