#pragma once

#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// Holds what no other target shows: in each phase of a fit the body is to be deformed little
/// against what it is when the phase begins (model::Strain, times `weight`, mm^2).
FitTargetMaker strain_target(double weight);

}  // namespace bodyline::optimize
