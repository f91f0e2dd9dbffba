#pragma once

#include <vector>

#include "model/body_plan.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// The faces of a stage, left half and central, from the nets of a body (xyz at the plan's
/// offsets).
std::vector<Surface> stage_surfaces(const BodyPlan& plan, Stage stage, const double* nets);

}  // namespace bodyline::model
