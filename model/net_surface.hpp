#pragma once

#include <vector>

#include "model/body_plan.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// A face of a plan with the net that it has in `nets` (xyz at the plan's offsets).
Surface net_surface(const Face& face, const double* nets);

/// All faces of a stage likewise, left half and central.
std::vector<Surface> net_surfaces(const BodyPlan& plan, Stage stage, const double* nets);

}  // namespace bodyline::model
