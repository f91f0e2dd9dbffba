#include "strokes/segment_distance.hpp"

#include <algorithm>
#include <array>

namespace bodyline::strokes {
namespace {

constexpr double parallel_sine_squared = 1e-20;

}  // namespace

double nearest_on_segment(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                          const Eigen::Vector3d& point) {
  const Eigen::Vector3d along = a1 - a0;
  const double squared = along.squaredNorm();
  return squared > 0.0 ? std::clamp(along.dot(point - a0) / squared, 0.0, 1.0) : 0.0;
}

SegmentApproach segment_approach(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                                 const Eigen::Vector3d& b0, const Eigen::Vector3d& b1) {
  const Eigen::Vector3d da = a1 - a0, db = b1 - b0;
  const auto approach = [&](double s, double t) {
    return SegmentApproach{s, t, (a0 + s * da - b0 - t * db).norm()};
  };
  // The nearest pair is inside both, or holds an end of one.
  std::array<SegmentApproach, 5> candidates{approach(0.0, nearest_on_segment(b0, b1, a0)),
                                            approach(nearest_on_segment(a0, a1, b0), 0.0),
                                            approach(nearest_on_segment(a0, a1, b1), 1.0),
                                            approach(1.0, nearest_on_segment(b0, b1, a1)),
                                            {}};
  const double aa = da.squaredNorm(), bb = db.squaredNorm(), ab = da.dot(db);
  const double determinant = aa * bb - ab * ab;
  candidates[4] = candidates[0];
  if (determinant > parallel_sine_squared * aa * bb) {
    const Eigen::Vector3d between = b0 - a0;
    const double s = (bb * da.dot(between) - ab * db.dot(between)) / determinant;
    const double t = (ab * da.dot(between) - aa * db.dot(between)) / determinant;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) candidates[4] = approach(s, t);
  }
  return *std::min_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.s < b.s);
  });
}

}  // namespace bodyline::strokes
