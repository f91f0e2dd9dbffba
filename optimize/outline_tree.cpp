#include "optimize/outline_tree.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::optimize {
namespace {

using Eigen::Vector2d;

// Points both of whose sides are open come twice, the second time after all others.
std::vector<int> samples_by_key(const OutlineSamples& samples) {
  std::vector<int> order;
  for (int k = 0; k < int(samples.points.size()); ++k) order.push_back(k);
  for (int k = 0; k < int(samples.points.size()); ++k) {
    if (samples.two_sided[k]) order.push_back(k);
  }
  return order;
}

std::vector<OrientedTree::Key> keys_of(const OutlineSamples& samples,
                                       const std::vector<int>& order) {
  std::vector<OrientedTree::Key> keys;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double sign = k < samples.points.size() ? 1.0 : -1.0;
    keys.push_back(outline_key(samples.points[order[k]], sign * samples.normals[order[k]]));
  }
  return keys;
}

}  // namespace

OrientedTree::Key outline_key(const Vector2d& point, const Vector2d& normal) {
  return OrientedTree::key({point.x(), point.y(), 0.0}, {normal.x(), normal.y(), 0.0},
                           outline_normal_length);
}

OutlineTree::OutlineTree(const OutlineSamples& samples)
    : samples_(&samples),
      sample_of_(samples_by_key(samples)),
      tree_(keys_of(samples, sample_of_)) {}

// From a sample along the outline while that comes nearer to a point.
int OutlineTree::walked(int sample, const Vector2d& point) const {
  const std::vector<Vector2d>& points = samples_->points;
  for (const int direction : {0, 1}) {
    for (std::size_t steps = 0; steps < points.size(); ++steps) {
      const int next = samples_->neighbours[sample][direction];
      if (next < 0 || !((points[next] - point).norm() < (points[sample] - point).norm())) break;
      sample = next;
    }
  }
  return sample;
}

std::optional<OutlineFoot> OutlineTree::nearest(const Vector2d& point,
                                                const Vector2d& normal) const {
  const std::optional<std::size_t> key = tree_.nearest_one(outline_key(point, normal));
  if (!key) return std::nullopt;
  const int sample = walked(sample_of_[*key], point);
  const Vector2d& from = samples_->points[sample];
  OutlineFoot foot{from, normal.dot(samples_->normals[sample]), false,
                   bool(samples_->two_sided[sample]), 0.0};
  if (foot.two_sided) foot.cosine = std::abs(foot.cosine);
  bool end = false;
  for (const int next : samples_->neighbours[sample]) {
    if (next < 0) {
      end = true;
      continue;
    }
    const Vector2d along = samples_->points[next] - from;
    const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Vector2d between = from + t * along;
    if ((between - point).norm() < (foot.point - point).norm()) foot.point = between;
  }
  const Vector2d offset = point - foot.point;
  if (!foot.two_sided) foot.outside = offset.dot(samples_->normals[sample]);
  foot.beyond = end && (offset - offset.dot(normal) * normal).norm() > samples_->spacing;
  return foot;
}

}  // namespace bodyline::optimize
