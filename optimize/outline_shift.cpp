#include "optimize/outline_shift.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "model/silhouette.hpp"
#include "optimize/outline_match.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int steps = 12;
constexpr double spacing = 10.0;                         // mm
constexpr double first_reach = 250.0, last_reach = 6.0;  // mm
constexpr double ridge = 1e-6;                           // of the mean of the normals' products

// Normal equations of a step: the offsets along the normals shall vanish.
struct Step {
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Vector2d right = Vector2d::Zero();
  double total = 0.0;

  void add(const OutlinePulls& found) {
    for (std::size_t k = 0; k < found.matches.size(); ++k) {
      const Vector3d& normal = found.matches[k].normal;
      const double weight = normal.dot(found.pulls[k].weight * normal);
      const double offset = (found.pulls[k].target - found.matches[k].foot).dot(normal);
      const Vector2d along(normal.x(), normal.z());
      matrix += weight * along * along.transpose();
      right -= weight * offset * along;
      total += weight;
    }
  }

  Vector3d move() const {
    if (!(total > 0.0)) return Vector3d::Zero();
    const Vector2d move =
        (matrix + ridge * total * Eigen::Matrix2d::Identity()).ldlt().solve(right);
    return {move.x(), 0.0, move.y()};
  }
};

OutlineSamples moved(OutlineSamples samples, const Vector3d& shift) {
  for (Vector2d& point : samples.points) point += model::project(samples.view, shift);
  return samples;
}

}  // namespace

Vector3d outline_shift(const model::Model& body,
                       const std::vector<model::PlacedDrawing>& drawings) {
  const model::SilhouetteBody seen = model::silhouette_body(body, model::Stage::body);
  std::vector<OutlineSamples> outlines;
  std::vector<std::vector<model::SilhouetteCurve>> silhouettes;
  for (const model::PlacedDrawing& drawing : drawings) {
    outlines.push_back(outline_samples(drawing, spacing));
    silhouettes.push_back(model::silhouette(seen, outlines.back().view));
  }
  Vector3d shift = Vector3d::Zero();
  for (int k = 0; k < steps; ++k) {
    const double reach = first_reach * std::pow(last_reach / first_reach, k / (steps - 1.0));
    Step step;
    for (std::size_t v = 0; v < outlines.size(); ++v) {
      step.add(
          match_outline(seen, silhouettes[v], moved(outlines[v], shift), {{reach, reach}, false}));
    }
    shift += step.move();
  }
  return shift;
}

std::vector<model::PlacedDrawing> shifted(std::vector<model::PlacedDrawing> drawings,
                                          const Vector3d& shift) {
  for (model::PlacedDrawing& drawing : drawings) {
    const Vector2d move = model::project(drawing.view, shift);
    for (model::DrawnPath& path : drawing.paths) {
      for (model::CubicSegment& segment : path.segments) {
        for (Vector2d& point : segment.points) point += move;
      }
    }
  }
  return drawings;
}

}  // namespace bodyline::optimize
