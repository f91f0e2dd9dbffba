#include "optimize/align_ends.hpp"

#include "optimize/align_box.hpp"
#include "optimize/align_search.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr double end_share = 0.1;  // of the length

// Measured: 0 to 0.14 of the coverage where a tenth to a half of a car is cut off, 0.83 and more
// for whole cars, estate cars and SUVs on the template too.
constexpr double least_share = 0.25;

// So far from its end a cut scan leaves the surface free to bend into that of the start model, mm.
constexpr double gap = 200.0;
constexpr double tail = 0.002;  // of the points at an end may lie anywhere

Vector3d stretched(const Vector3d& sample, const BodySamples& shape, const Placement& placement) {
  return shape.centre() + placement.stretch.cwiseProduct(sample - shape.centre());
}

Vector3d to_cloud(const Vector3d& point, const Placement& placement) {
  return placement.rotation.transpose() * (point - placement.translation);
}

double end_coverage(const PointTree& tree, const BodySamples& shape, const Placement& placement,
                    double end) {
  constexpr double near = 2.0 * shape_tolerance;
  const double tip = end < 0.0 ? shape.low.x() : shape.high.x();
  double covered = 0.0, all = 0.0;
  for (const Vector3d& sample : shape.points()) {
    if (end * (tip - sample.x()) > end_share * shape.extents().x()) continue;
    const Vector3d place = to_cloud(stretched(sample, shape, placement), placement);
    all += 1.0;
    covered += tree.nearest(place).squared_distance < near * near;
  }
  return covered / all;
}

}  // namespace

MissingEnd missing_end(const AlignCloud& cloud, const BodySamples& shape,
                       const Placement& placement, double coverage) {
  const PointTree tree(cloud.points);
  const bool front = end_coverage(tree, shape, placement, -1.0) < least_share * coverage;
  const bool rear = end_coverage(tree, shape, placement, 1.0) < least_share * coverage;
  if (front) return rear ? MissingEnd::both : MissingEnd::front;
  return rear ? MissingEnd::rear : MissingEnd::none;
}

model::Scan samples_beyond(const AlignCloud& cloud, const BodySamples& shape,
                           const Placement& placement, MissingEnd missing) {
  const PrincipalBox box = box_along(cloud, placement.rotation, tail);
  const double first = box.low.x() + placement.translation.x() - gap;
  const double last = box.high.x() + placement.translation.x() + gap;
  model::Scan beyond;
  for (std::size_t k = 0; k < shape.points().size(); ++k) {
    const Vector3d point = stretched(shape.points()[k], shape, placement);
    const bool before = missing != MissingEnd::rear && point.x() < first;
    const bool behind = missing != MissingEnd::front && point.x() > last;
    if (!before && !behind) continue;
    beyond.points.push_back(to_cloud(point, placement));
    const Vector3d normal = shape.normals[k].cwiseQuotient(placement.stretch).normalized();
    beyond.normals.push_back(placement.rotation.transpose() * normal);
  }
  return beyond;
}

}  // namespace bodyline::optimize
