#pragma once

#include <string>
#include <vector>

#include "optimize/feature_line.hpp"

namespace bodyline::optimize {

/// How far a line is from its curve.
struct FeatureDeviation {
  std::string curve;
  double median = 0.0, p90 = 0.0;  ///< of the line's points, mm
};

/// Compares lines with the curves of a body, one by one. Throws std::invalid_argument as tied_line
/// does.
std::vector<FeatureDeviation> measure_features(const model::Model& model,
                                               const std::vector<FeatureLine>& lines);

}  // namespace bodyline::optimize
