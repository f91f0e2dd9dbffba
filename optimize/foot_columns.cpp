#include "optimize/foot_columns.hpp"

namespace bodyline::optimize {

model::FootPointArrays FootColumns::arrays() {
  model::FootPointArrays a;
  a.count = count_;
  a.x = columns_[point_at], a.y = columns_[point_at + 1], a.z = columns_[point_at + 2];
  a.u = columns_[u_at], a.v = columns_[v_at];
  for (int c = 0; c < 3; ++c) {
    a.foot[c] = columns_[foot_at + c];
    a.normal[c] = columns_[normal_at + c];
  }
  return a;
}

void PullColumns::set(int k, double u, double v, const Eigen::Vector3d& target,
                      const Eigen::Matrix3d& weight) {
  const Eigen::Vector3d pulled = weight * target;
  const double entries[6] = {weight(0, 0), weight(0, 1), weight(0, 2),
                             weight(1, 1), weight(1, 2), weight(2, 2)};
  columns_[u_at][k] = u;
  columns_[v_at][k] = v;
  for (int e = 0; e < 6; ++e) columns_[weight_at + e][k] = entries[e];
  columns_.set_vector(target_at, k, pulled);
  sums_.constant += target.dot(pulled);
  sums_.weight += weight.trace();
}

model::PullArrays PullColumns::arrays() {
  model::PullArrays a;
  a.count = count_;
  a.u = columns_[u_at], a.v = columns_[v_at];
  for (int e = 0; e < 6; ++e) a.weight[e] = columns_[weight_at + e];
  for (int c = 0; c < 3; ++c) a.weighted_target[c] = columns_[target_at + c];
  return a;
}

}  // namespace bodyline::optimize
