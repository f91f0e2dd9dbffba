#pragma once

#include <vector>

#include "optimize/feature_line.hpp"
#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// Feature lines as a target of a fit: the mean squared distance between curves and lines, both
/// ways, square to the curve, mm^2. At every stage the curve is that of the whole patches: where
/// patches are cut back it lies within the transition. What a line does not cover it leaves free.
/// Throws std::invalid_argument as tied_line does.
FitTargetMaker feature_target(const model::Model& model, const std::vector<FeatureLine>& lines,
                              double weight = 1.0);

}  // namespace bodyline::optimize
