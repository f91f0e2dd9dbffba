#include "optimize/align_search.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "optimize/align_box.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int rolls = 24;
constexpr int coarse_points = 400;
constexpr int fine_points = 2500;
constexpr int kept_candidates = 8;
constexpr double same_way = 0.3;  // radians between rotations that count as one

const std::vector<double> coarse_scales{500, 500, 500, 350, 350, 250, 250, 180, 180, 130, 130, 130};
const std::vector<double> flip_scales{250, 250, 180, 180, 130, 130, 100, 80, 60, 60};
const std::vector<double> fine_scales{130, 100, 100, 80, 80, 60, 60};

Placement started(const AlignCloud& cloud, const BodySamples& shape, const Matrix3d& rotation) {
  const PrincipalBox box = box_along(cloud, rotation, 0.01);
  Placement placement;
  placement.rotation = rotation;
  placement.translation = shape.centre() - 0.5 * (box.low + box.high);
  placement.stretch[0] =
      std::clamp(box.extents()[0] / shape.extents()[0], 1.0 / most_stretch[0], most_stretch[0]);
  return placement;
}

std::vector<Placement> starts(const AlignCloud& boxed, const BodySamples& shape) {
  const AlignCloud few = thinned(boxed, fine_points);
  const Matrix3d axes = principal_box(boxed).axes;
  std::vector<Placement> result;
  for (double sign : {1.0, -1.0}) {
    for (int roll = 0; roll < rolls; ++roll) {
      const double angle = 2.0 * std::numbers::pi * roll / rolls;
      Matrix3d rotation;
      rotation.row(0) = sign * axes.row(0);
      rotation.row(1) = std::cos(angle) * axes.row(1) + std::sin(angle) * axes.row(2);
      rotation.row(2) = rotation.row(0).cross(rotation.row(1));
      result.push_back(started(few, shape, rotation));
    }
  }
  return result;
}

// Registers and scores each start; the best come first, ties in the order of the starts.
std::vector<Candidate> tried(const AlignCloud& cloud, const BodySamples& shape,
                             const std::vector<Placement>& starts,
                             const std::vector<double>& scales, double tolerance) {
  const PointTree tree(cloud.points);
  std::vector<Candidate> result(starts.size());
  tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t i) {
    result[i].placement = registered(cloud, shape, starts[i], scales, all_free);
    result[i].score = placement_score(cloud, tree, shape, result[i].placement, tolerance);
  });
  std::stable_sort(result.begin(), result.end(), [](const Candidate& a, const Candidate& b) {
    return a.score.total() > b.score.total();
  });
  return result;
}

double angle_between(const Matrix3d& a, const Matrix3d& b) {
  return Eigen::AngleAxisd(a * b.transpose()).angle();
}

// The first `count` that differ in rotation.
std::vector<Placement> distinct(const std::vector<Candidate>& candidates, std::size_t count) {
  std::vector<Placement> result;
  for (const Candidate& candidate : candidates) {
    const auto same = [&](const Placement& other) {
      return angle_between(other.rotation, candidate.placement.rotation) < same_way;
    };
    if (std::none_of(result.begin(), result.end(), same)) result.push_back(candidate.placement);
    if (result.size() == count) break;
  }
  return result;
}

// The placement turned by half a turn about each axis of the car.
std::vector<Placement> flipped(const Placement& placement, const BodySamples& shape) {
  std::vector<Placement> result;
  for (int axis = 0; axis < 3; ++axis) {
    const Matrix3d turn =
        Eigen::AngleAxisd(std::numbers::pi, Vector3d::Unit(axis)).toRotationMatrix();
    Placement other = placement;
    other.rotation = turn * placement.rotation;
    other.translation = shape.centre() + turn * (placement.translation - shape.centre());
    result.push_back(other);
  }
  return result;
}

}  // namespace

std::vector<Candidate> search_placements(const AlignCloud& cloud, const AlignCloud& boxed,
                                         const BodySamples& shape) {
  const AlignCloud coarse = thinned(boxed, coarse_points), fine = thinned(cloud, fine_points);
  std::vector<Candidate> found =
      tried(coarse, shape, starts(boxed, shape), coarse_scales, 2.0 * shape_tolerance);
  found = tried(fine, shape, distinct(found, kept_candidates), fine_scales, shape_tolerance);
  const auto flips =
      tried(fine, shape, flipped(found.front().placement, shape), flip_scales, shape_tolerance);
  found.insert(found.end(), flips.begin(), flips.end());
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.score.total() > b.score.total();
  });
  const Matrix3d best = found.front().placement.rotation;
  found.erase(std::remove_if(found.begin() + 1, found.end(),
                             [&](const Candidate& other) {
                               return angle_between(other.placement.rotation, best) < same_way;
                             }),
              found.end());
  found.resize(std::min<std::size_t>(found.size(), 2));
  return found;
}

}  // namespace bodyline::optimize
