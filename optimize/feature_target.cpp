#include "optimize/feature_target.hpp"

#include <cmath>

#include "model/net_surface.hpp"
#include "optimize/feature_curve.hpp"
#include "optimize/pull_term.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// The nearest point of a line; `beyond` tells that it is an end of the line, and the point that is
// asked about lies past it.
Vector3d nearest_of_line(const TiedLine& line, const FeaturePoint& at, bool& beyond) {
  Vector3d nearest = line.polylines.front().front();
  double least = (line.seen * (nearest - at.position)).squaredNorm();
  bool end = true;
  for (const std::vector<Vector3d>& points : line.polylines) {
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const Vector3d along = line.seen * (points[k + 1] - points[k]);
      const double squared = along.squaredNorm();
      const double share =
          squared > 0.0 ? along.dot(line.seen * (at.position - points[k])) / squared : 0.0;
      const double t = std::clamp(share, 0.0, 1.0);
      const Vector3d candidate = points[k] + t * (points[k + 1] - points[k]);
      const double distance = (line.seen * (candidate - at.position)).squaredNorm();
      if (!(distance < least)) continue;
      least = distance;
      nearest = candidate;
      end = (k == 0 && share < 0.0) || (k + 2 == points.size() && share > 1.0);
    }
  }
  beyond =
      end && std::abs((line.seen * (nearest - at.position)).dot(at.direction)) > feature_spacing;
  return nearest;
}

// Square to the curve, in what is seen.
Matrix3d across(const TiedLine& line, const FeaturePoint& at) {
  const Vector3d along = line.seen * at.direction;
  if (!(along.norm() > 1e-6)) return line.seen;
  return line.seen - along * along.transpose() / along.squaredNorm();
}

class FeatureTarget : public FitTarget {
 public:
  FeatureTarget(const model::BodyPlan& plan, std::shared_ptr<const std::vector<TiedLine>> lines,
                double weight)
      : plan_(&plan),
        lines_(std::move(lines)),
        weight_(weight),
        term_(std::make_shared<PullTerm>(plan, model::Stage::base)) {}

  void match(const double* nets, const FitRound& round) override;
  model::WeightedNetTerm term() const override { return {term_, weight_}; }
  std::optional<TargetFit> fit() const override { return target_fit(distances_); }

 private:
  void pull(const TiedLine& line, const FeaturePoint& at, const Vector3d& target, double length);

  const model::BodyPlan* plan_;
  std::shared_ptr<const std::vector<TiedLine>> lines_;
  double weight_;
  std::shared_ptr<PullTerm> term_;
  std::vector<double> distances_;
  std::vector<Match> matches_;
  std::vector<MatchPull> pulls_;
  double total_ = 0.0;
};

void FeatureTarget::pull(const TiedLine& line, const FeaturePoint& at, const Vector3d& target,
                         double length) {
  Match match;
  match.face = line.side.patch;
  match.u = at.u;
  match.v = at.v;
  match.foot = at.position;
  match.normal.setZero();  // the pull is not along one direction
  matches_.push_back(match);
  pulls_.push_back({target, length * across(line, at)});
  total_ += length;
}

void FeatureTarget::match(const double* nets, const FitRound&) {
  matches_.clear();
  pulls_.clear();
  distances_.clear();
  total_ = 0.0;
  for (const TiedLine& line : *lines_) {
    const model::Surface patch = model::net_surface(plan_->base_faces[line.side.patch], nets);
    const FeatureCurve curve(patch, line.side.side);
    for (const std::vector<Vector3d>& points : line.polylines) {
      for (const Vector3d& point : points) {
        const FeaturePoint at = curve.nearest(point, line.seen);
        distances_.push_back((line.seen * (point - at.position)).norm());
        pull(line, at, point, feature_spacing);
      }
    }
    for (const FeaturePoint& sample : curve.samples()) {
      bool beyond = false;
      const Vector3d target = nearest_of_line(line, sample, beyond);
      if (!beyond) pull(line, sample, target, sample.length);
    }
  }
  term_->set(matches_, pulls_, total_);
}

}  // namespace

FitTargetMaker feature_target(const model::Model& model, const std::vector<FeatureLine>& lines,
                              double weight) {
  const auto all = std::make_shared<std::vector<TiedLine>>();
  for (const FeatureLine& line : lines) all->push_back(tied_line(model, line));
  return [all, weight](const model::BodyPlan& plan, model::Stage, FitDetail) {
    return std::make_unique<FeatureTarget>(plan, all, weight);
  };
}

}  // namespace bodyline::optimize
