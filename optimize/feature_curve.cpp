#include "optimize/feature_curve.hpp"

#include <algorithm>

#include "model/check_edge_jet.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr int sample_count = 65;
constexpr int newton_steps = 8;

}  // namespace

FeatureCurve::FeatureCurve(const model::Surface& patch, model::Side side)
    : patch_(&patch), side_(side) {
  const double y_first = at(0.0).position.y(), y_last = at(1.0).position.y();
  if (y_first * y_last < 0.0) (y_first < 0.0 ? last_ : first_) = 0.5;
  for (int k = 0; k < sample_count; ++k)
    samples_.push_back(at(first_ + (last_ - first_) * k / (sample_count - 1)));
  for (int k = 1; k < sample_count; ++k) {
    const double half = 0.5 * (samples_[k].position - samples_[k - 1].position).norm();
    samples_[k].length += half;
    samples_[k - 1].length += half;
  }
}

FeaturePoint FeatureCurve::at(double t) const {
  const model::EdgeJet jet = model::edge_jet(*patch_, side_, t);
  const double end = side_ == model::Side::u1 || side_ == model::Side::v1 ? 1.0 : 0.0;
  const bool along_v = model::along_v(side_);
  return {along_v ? end : t, along_v ? t : end, jet.point, jet.along.normalized(), 0.0};
}

FeaturePoint FeatureCurve::nearest(const Vector3d& point, const Eigen::Matrix3d& seen) const {
  const auto squared = [&](const FeaturePoint& sample) {
    return (seen * (sample.position - point)).squaredNorm();
  };
  const auto best = std::min_element(
      samples_.begin(), samples_.end(),
      [&](const FeaturePoint& a, const FeaturePoint& b) { return squared(a) < squared(b); });
  double t = model::along_v(side_) ? best->v : best->u;
  for (int step = 0; step < newton_steps; ++step) {
    const model::EdgeJet jet = model::edge_jet(*patch_, side_, t);
    const Vector3d along = seen * jet.along;
    const double slope = along.squaredNorm();
    if (!(slope > 0.0)) break;
    t = std::clamp(t - along.dot(jet.point - point) / slope, first_, last_);
  }
  const FeaturePoint found = at(t);
  return squared(found) <= squared(*best) ? found : *best;
}

}  // namespace bodyline::optimize
