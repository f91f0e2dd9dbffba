#include "optimize/outline_match.hpp"

#include <algorithm>
#include <cmath>

#include "optimize/geman_mcclure.hpp"
#include "optimize/silhouette_tree.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double outside_reach = 250.0;  // mm

// Half of the way to both neighbours of a point of a piece.
double length_at(const model::SilhouetteCurve& piece, int k) {
  const int count = int(piece.points.size());
  double length = 0.0;
  for (const int step : {-1, 1}) {
    const int next = piece.closed ? (k + step + count) % count : k + step;
    if (next < 0 || next >= count) continue;
    length += 0.5 * (piece.points[next].picture - piece.points[k].picture).norm();
  }
  return length;
}

class OutlineMatcher {
 public:
  OutlineMatcher(const model::SilhouetteBody& body,
                 const std::vector<model::SilhouetteCurve>& pieces, const OutlineSamples& samples,
                 const OutlineMatching& matching)
      : body_(body),
        pieces_(pieces),
        samples_(samples),
        matching_(matching),
        axes_(model::view_axes(samples.view)) {}

  OutlinePulls run() {
    pull_from_drawing();
    if (matching_.from_body) pull_from_body();
    return std::move(result_);
  }

 private:
  void pull_from_drawing();
  void pull_from_body();
  void add(const model::SilhouetteCurve& piece, const model::SilhouettePoint& at,
           const Vector2d& target, double weight, double reach);
  double reach_of(const model::SilhouetteCurve& piece) const {
    return piece.kind == model::SilhouetteKind::contour ? matching_.reach.normal
                                                        : matching_.reach.rim;
  }
  Vector3d lifted(const Vector2d& picture) const {
    return picture.x() * axes_.right + picture.y() * axes_.up;
  }

  const model::SilhouetteBody& body_;
  const std::vector<model::SilhouetteCurve>& pieces_;
  const OutlineSamples& samples_;
  const OutlineMatching& matching_;
  model::ViewAxes axes_;
  OutlinePulls result_;
};

void OutlineMatcher::add(const model::SilhouetteCurve& piece, const model::SilhouettePoint& at,
                         const Vector2d& target, double weight, double reach) {
  const Vector2d offset = target - at.picture;
  weight *= geman_mcclure(offset.squaredNorm(), reach);
  Match match;
  match.face = piece.face;
  match.u = at.u;
  match.v = at.v;
  match.foot = at.position;
  match.normal = lifted(at.normal);
  match.distance = offset.dot(at.normal) < 0.0 ? -offset.norm() : offset.norm();
  const Eigen::Matrix3d pull = match.normal * match.normal.transpose();
  result_.matches.push_back(match);
  result_.pulls.push_back({lifted(target), weight * pull});
}

void OutlineMatcher::pull_from_drawing() {
  const SilhouetteTree tree(body_, samples_.view, pieces_);
  for (std::size_t k = 0; k < samples_.points.size(); ++k) {
    const Vector2d& point = samples_.points[k];
    SilhouetteFoot foot = tree.nearest(point, samples_.normals[k]);
    if (foot.piece < 0) continue;
    double cosine = foot.point.normal.dot(samples_.normals[k]);
    if (samples_.two_sided[k]) {
      const SilhouetteFoot other = tree.nearest(point, -samples_.normals[k]);
      const double other_cosine = -other.point.normal.dot(samples_.normals[k]);
      const auto measure = [&](const SilhouetteFoot& at, double c) {
        return (at.point.picture - point).norm() + outline_normal_length * (1.0 - c);
      };
      if (measure(other, other_cosine) < measure(foot, cosine)) {
        foot = other;
        cosine = other_cosine;
      }
    }
    cosine = std::max(cosine, 0.0);
    add(pieces_[foot.piece], foot.point, point, samples_.spacing * cosine * cosine,
        reach_of(pieces_[foot.piece]));
    result_.distances.push_back(result_.matches.back().distance);
  }
}

void OutlineMatcher::pull_from_body() {
  if (samples_.points.empty()) return;
  const OutlineTree tree(samples_);
  for (const model::SilhouetteCurve& piece : pieces_) {
    for (int k = 0; k < int(piece.points.size()); ++k) {
      const model::SilhouettePoint& at = piece.points[k];
      const std::optional<OutlineFoot> foot = tree.nearest(at.picture, at.normal);
      // A line that is open on both sides does not tell which part of the body it shows.
      if (!foot || foot->beyond || foot->two_sided) continue;
      const double cosine = std::max(foot->cosine, 0.0);
      // What is drawn may show more than a body (wheels, mirrors), but not less.
      double reach = reach_of(piece);
      if (foot->outside > 0.0) reach = std::max(reach, outside_reach);
      add(piece, at, foot->point, length_at(piece, k) * cosine * cosine, reach);
    }
  }
}

}  // namespace

OutlinePulls match_outline(const model::SilhouetteBody& body,
                           const std::vector<model::SilhouetteCurve>& pieces,
                           const OutlineSamples& samples, const OutlineMatching& matching) {
  return OutlineMatcher(body, pieces, samples, matching).run();
}

}  // namespace bodyline::optimize
