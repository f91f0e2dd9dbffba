#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/body_plan.hpp"

namespace bodyline::model {

/// The faces of a stage that the patterns choose (`name_is_chosen`), in the plan's order; they live
/// as long as the plan. Throws std::invalid_argument, with the nearest name, when a pattern matches
/// no face.
std::vector<const Face*> choose_faces(const BodyPlan& plan, Stage stage,
                                      std::span<const std::string> patterns);

}  // namespace bodyline::model
