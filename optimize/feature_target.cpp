#include "optimize/feature_target.hpp"

#include <cmath>
#include <stdexcept>

#include "model/build.hpp"
#include "model/net_surface.hpp"
#include "model/suggest.hpp"
#include "optimize/feature_curve.hpp"
#include "optimize/quantile.hpp"
#include "optimize/scan_term.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double spacing = 10.0;  // of a line's points, mm
constexpr double heeded_share = 0.9;

// A line at even distances, in the left half.
struct TiedLine {
  model::PatchSide side;  // of the patch that has the curve
  Matrix3d seen;          // see FeatureCurve
  std::vector<std::vector<Vector3d>> polylines;
};

model::PatchSide side_with(const model::Model& model, const std::string& curve) {
  std::vector<std::string> names;
  for (const model::Curve& known : model.curves) names.push_back(known.name);
  for (int p = 0; p < int(model.patches.size()); ++p) {
    for (const model::Side side : model::all_sides) {
      const model::SideCurve& use = model.patches[p].sides[int(side)];
      if (!use.mirrored && names[use.curve] == curve) return {p, side};
    }
  }
  throw std::invalid_argument("there is no curve '" + curve + "'; the nearest name is '" +
                              model::nearest_name(curve, names) + "'");
}

Vector3d in_left_half(Vector3d point) {
  point.y() = -std::abs(point.y());
  return point;
}

std::vector<Vector3d> even_points(const std::vector<Vector3d>& polyline) {
  std::vector<Vector3d> points;
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
    const Vector3d along = polyline[k + 1] - polyline[k];
    const int steps = std::max(1, int(std::ceil(std::min(along.norm() / spacing, 1e5))));
    for (int q = 0; q < steps; ++q) points.push_back(polyline[k] + double(q) / steps * along);
  }
  points.push_back(polyline.back());
  return points;
}

TiedLine tied(const model::Model& model, const FeatureLine& line) {
  TiedLine result{side_with(model, line.curve), Matrix3d::Identity(), {}};
  if (line.view) {
    const Vector3d toward = model::view_axes(*line.view).toward;
    result.seen -= toward * toward.transpose();
  }
  for (const std::vector<Vector3d>& polyline : line.polylines) {
    if (polyline.empty()) continue;
    std::vector<Vector3d>& points = result.polylines.emplace_back();
    for (const Vector3d& point : even_points(polyline)) {
      Vector3d lifted = point;
      if (line.view) {
        const model::ViewAxes axes = model::view_axes(*line.view);
        lifted = point.x() * axes.right + point.y() * axes.up;
      }
      points.push_back(in_left_half(lifted));
    }
  }
  if (result.polylines.empty())
    throw std::invalid_argument("the line of the feature '" + line.curve + "' has no points");
  return result;
}

std::vector<TiedLine> tied(const model::Model& model, const std::vector<FeatureLine>& lines) {
  std::vector<TiedLine> result;
  for (const FeatureLine& line : lines) result.push_back(tied(model, line));
  return result;
}

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
  beyond = end && std::abs((line.seen * (nearest - at.position)).dot(at.direction)) > spacing;
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
        term_(std::make_shared<ScanTerm>(plan, model::Stage::base)) {}

  void match(const double* nets, const FitRound& round) override;
  model::WeightedNetTerm term() const override { return {term_, weight_}; }
  std::string name() const override { return "feature lines"; }
  double distance() const override { return quantile(distances_, 0.5); }
  double misfit() const override { return trimmed_rms(distances_, heeded_share); }

 private:
  void pull(const TiedLine& line, const FeaturePoint& at, const Vector3d& target, double length);

  const model::BodyPlan* plan_;
  std::shared_ptr<const std::vector<TiedLine>> lines_;
  double weight_;
  std::shared_ptr<ScanTerm> term_;
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
        pull(line, at, point, spacing);
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

void check_feature_lines(const model::Model& model, const std::vector<FeatureLine>& lines) {
  for (const FeatureLine& line : lines) side_with(model, line.curve);
}

FitTargetMaker feature_target(const model::Model& model, const std::vector<FeatureLine>& lines,
                              double weight) {
  const auto all = std::make_shared<const std::vector<TiedLine>>(tied(model, lines));
  return [all, weight](const model::BodyPlan& plan, model::Stage, FitDetail) {
    return std::make_unique<FeatureTarget>(plan, all, weight);
  };
}

std::vector<FeatureDeviation> measure_features(const model::Model& model,
                                               const std::vector<FeatureLine>& lines) {
  const std::vector<model::Surface> patches =
      model::build(model, model::Stage::base, model::Halves::left_and_central);
  std::vector<FeatureDeviation> results;
  for (const FeatureLine& feature : lines) {
    const TiedLine line = tied(model, feature);
    const FeatureCurve curve(patches[line.side.patch], line.side.side);
    std::vector<double> distances;
    for (const std::vector<Vector3d>& points : line.polylines) {
      for (const Vector3d& point : points) {
        const FeaturePoint at = curve.nearest(point, line.seen);
        distances.push_back((line.seen * (point - at.position)).norm());
      }
    }
    results.push_back({feature.curve, quantile(distances, 0.5), quantile(distances, 0.9)});
  }
  return results;
}

}  // namespace bodyline::optimize
