#include "optimize/fit_start.hpp"

#include <algorithm>
#include <array>

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

struct Extent {
  Vector3d low, high;
};

Extent extent_of(const model::Model& model) {
  Extent box{Vector3d::Constant(1e300), Vector3d::Constant(-1e300)};
  for (const model::Curve& curve : model.curves) {
    for (const Vector3d& point : curve.points)
      box = {box.low.cwiseMin(point), box.high.cwiseMax(point)};
  }
  return box;
}

// Where parts of a saloon's upper body lie on an estate car, as shares of the length: the middle of
// the roof, its rear edge, the lower edge of the rear window, the tail.
constexpr std::array<double, 4> saloon{0.52, 0.705, 0.873, 1.0};
constexpr std::array<double, 4> estate{0.52, 0.905, 0.96, 1.0};
// The lower body stays; shares of the height.
constexpr double stays_below = 0.5, moves_above = 0.7;

double moved_share(double share) {
  if (share <= saloon.front() || share >= saloon.back()) return share;
  std::size_t k = 1;
  while (share > saloon[k]) ++k;
  const double t = (share - saloon[k - 1]) / (saloon[k] - saloon[k - 1]);
  return estate[k - 1] + t * (estate[k] - estate[k - 1]);
}

Vector3d estate_point(const Vector3d& point, const Extent& box) {
  const Vector3d size = box.high - box.low;
  const double along = (point.x() - box.low.x()) / size.x();
  const double up = (point.z() - box.low.z()) / size.z();
  const double t = std::clamp((up - stays_below) / (moves_above - stays_below), 0.0, 1.0);
  const double weight = t * t * (3.0 - 2.0 * t);
  return point + Vector3d(weight * size.x() * (moved_share(along) - along), 0.0, 0.0);
}

}  // namespace

std::vector<FitStart> usual_fit_starts() {
  return {{{0, 0, 0}, 0.0},   {{100, 0, 0}, 0.0}, {{-100, 0, 0}, 0.0},
          {{0, 0, -80}, 0.0}, {{0, 0, 0}, 1.0},   {{-100, 0, 0}, 1.0}};
}

model::Model started(const model::Model& model, const FitStart& start) {
  const Extent box = extent_of(model);
  model::Model result = model;
  for (model::Curve& curve : result.curves) {
    for (Vector3d& point : curve.points)
      point += start.move + start.estate * (estate_point(point, box) - point);
  }
  return result;
}

}  // namespace bodyline::optimize
