#include "model/check_fold.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/measures.hpp"
#include "model/measures_extreme.hpp"

namespace bodyline::model {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
// A normal shorter than this part of the mean one (both before scaling to unit length) has lost its
// direction to rounding: next to a degenerate point.
constexpr double shortest_normal = 1e-6;

Eigen::Vector3d scaled_normal(const Surface& surface, double u, double v) {
  const SurfaceJet at = jet(surface, u, v, 1);
  return at.d[1].cross(at.d[2]);
}

}  // namespace

FoldCheck check_fold(const Surface& surface, int cells) {
  const Eigen::Vector3d mean = vector_area(surface);
  const double shortest = shortest_normal * face_area(surface);
  const auto turn = [&](double u, double v) {
    const Eigen::Vector3d normal = scaled_normal(surface, u, v);
    if (normal.norm() <= shortest) return std::numeric_limits<double>::quiet_NaN();
    return degrees * std::atan2(normal.cross(mean).norm(), normal.dot(mean));
  };
  const Extreme worst = largest_value(turn, cells);
  FoldCheck check;
  check.max_turn_deg =
      std::isfinite(worst.value) ? worst.value : std::numeric_limits<double>::quiet_NaN();
  check.folded = !(check.max_turn_deg <= 90.0);
  check.u = worst.u;
  check.v = worst.v;
  check.point = jet(surface, worst.u, worst.v, 0).d[0];
  return check;
}

}  // namespace bodyline::model
