#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/view.hpp"
#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// A line drawn on a car that a named curve of the body shall follow.
struct FeatureLine {
  std::string curve;
  /// In space; or as seen in this view, where points hold x and y of the picture and 0.
  std::optional<model::View> view;
  std::vector<std::vector<Eigen::Vector3d>> polylines;  ///< mm, in the coordinates of the model
};

/// Throws std::invalid_argument, with the nearest name, when a model has no such curve.
void check_feature_lines(const model::Model& model, const std::vector<FeatureLine>& lines);

/// Feature lines as a target of a fit: the mean squared distance between curves and lines, both
/// ways, square to the curve, mm^2. At every stage the curve is that of the whole patches: where
/// patches are cut back it lies within the transition. What a line does not cover it leaves free.
FitTargetMaker feature_target(const model::Model& model, const std::vector<FeatureLine>& lines,
                              double weight = 1.0);

/// How far a line is from its curve.
struct FeatureDeviation {
  std::string curve;
  double median = 0.0, p90 = 0.0;  ///< of the line's points, mm
};
std::vector<FeatureDeviation> measure_features(const model::Model& model,
                                               const std::vector<FeatureLine>& lines);

}  // namespace bodyline::optimize
