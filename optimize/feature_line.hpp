#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/view.hpp"

namespace bodyline::optimize {

/// A line drawn on a car that a named curve of the body shall follow.
struct FeatureLine {
  std::string curve;
  /// In space; or as seen in this view, where points hold x and y of the picture and 0.
  std::optional<model::View> view;
  std::vector<std::vector<Eigen::Vector3d>> polylines;  ///< mm, in the coordinates of the model
};

/// Throws std::invalid_argument, with the nearest name, when a model has no such curve.
void check_feature_curves(const model::Model& model, const std::vector<FeatureLine>& lines);

/// Throws std::invalid_argument when a line has no points, one beyond model::largest_coordinate, or
/// too many: at most 20000 in distances of 10 mm, which is 200 m.
void check_feature_points(const FeatureLine& line);

/// mm between the points of a TiedLine, where its line has no more.
inline constexpr double feature_spacing = 10.0;

/// A line at even distances in the left half of the model, and the side of the patch that has its
/// curve.
struct TiedLine {
  model::PatchSide side;
  Eigen::Matrix3d seen;  ///< projects onto what the line shows, see FeatureCurve
  std::vector<std::vector<Eigen::Vector3d>> polylines;
};

/// Checks a line and ties it to its curve. Throws std::invalid_argument as both checks do.
TiedLine tied_line(const model::Model& model, const FeatureLine& line);

}  // namespace bodyline::optimize
