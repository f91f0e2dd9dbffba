#include "optimize/feature_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/largest_coordinate.hpp"
#include "model/suggest.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double most_points = 20'000;  // of a line at even distances

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

// Of points between two corners of a polyline, the first corner among them.
double steps_between(const Vector3d& a, const Vector3d& b) {
  return std::max(1.0, std::ceil((b - a).norm() / feature_spacing));
}

std::vector<Vector3d> even_points(const std::vector<Vector3d>& polyline) {
  std::vector<Vector3d> points;
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
    const Vector3d along = polyline[k + 1] - polyline[k];
    const int steps = int(steps_between(polyline[k], polyline[k + 1]));
    for (int q = 0; q < steps; ++q) points.push_back(polyline[k] + double(q) / steps * along);
  }
  points.push_back(polyline.back());
  return points;
}

Vector3d in_space(const FeatureLine& line, const Vector3d& point) {
  if (!line.view) return point;
  const model::ViewAxes axes = model::view_axes(*line.view);
  return point.x() * axes.right + point.y() * axes.up;
}

Vector3d in_left_half(Vector3d point) {
  point.y() = -std::abs(point.y());
  return point;
}

}  // namespace

void check_feature_curves(const model::Model& model, const std::vector<FeatureLine>& lines) {
  for (const FeatureLine& line : lines) side_with(model, line.curve);
}

void check_feature_points(const FeatureLine& line) {
  const std::string name = "the line of the feature '" + line.curve + "'";
  double count = 0.0;
  for (const std::vector<Vector3d>& polyline : line.polylines) {
    for (std::size_t k = 0; k < polyline.size(); ++k) {
      const bool near =
          polyline[k].allFinite() && polyline[k].cwiseAbs().maxCoeff() <= model::largest_coordinate;
      if (!near)
        throw std::invalid_argument(name + " goes beyond 1 km; its unit or scale may be wrong");
      count += k == 0 ? 1.0 : steps_between(polyline[k - 1], polyline[k]);
    }
  }
  if (count == 0.0) throw std::invalid_argument(name + " has no points");
  if (count > most_points) {
    throw std::invalid_argument(
        name + " is too long or has too many points; 20000 at distances of 10 mm are the most");
  }
}

TiedLine tied_line(const model::Model& model, const FeatureLine& line) {
  TiedLine result{side_with(model, line.curve), Matrix3d::Identity(), {}};
  check_feature_points(line);
  if (line.view) {
    const Vector3d toward = model::view_axes(*line.view).toward;
    result.seen -= toward * toward.transpose();
  }
  for (const std::vector<Vector3d>& polyline : line.polylines) {
    if (polyline.empty()) continue;
    std::vector<Vector3d>& points = result.polylines.emplace_back();
    for (const Vector3d& point : even_points(polyline))
      points.push_back(in_left_half(in_space(line, point)));
  }
  return result;
}

}  // namespace bodyline::optimize
