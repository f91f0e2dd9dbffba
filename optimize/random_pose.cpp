#include "optimize/random_pose.hpp"

#include <Eigen/Geometry>
#include <array>

#include "model/random.hpp"

namespace bodyline::optimize {
namespace {

constexpr std::array<double, 4> mm_per_unit{1.0, 10.0, 1000.0, 25.4};
constexpr double farthest_mm = 5000.0;

// A direction in four dimensions is a uniform rotation.
Eigen::Matrix3d random_rotation(model::Random& random) {
  Eigen::Vector4d q;
  for (int k = 0; k < 4; ++k) q[k] = random.normal();
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

}  // namespace

model::Pose random_pose(std::uint64_t seed) {
  model::Random random(seed);
  model::Pose pose;
  pose.rotation = random_rotation(random);
  for (int c = 0; c < 3; ++c) pose.translation[c] = farthest_mm * (2.0 * random.uniform() - 1.0);
  pose.scale = mm_per_unit[random.below(mm_per_unit.size())];
  return pose;
}

}  // namespace bodyline::optimize
