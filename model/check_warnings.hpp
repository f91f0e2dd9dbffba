#pragma once

#include <string>
#include <vector>

#include "model/body_plan.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// What a user should know of a body that is built as it should be, one sentence each: corner
/// patches that are not polynomial, and ends at which the handle of an uncut side had to be lifted
/// because the free edge beyond does not lead away from it (section 6). Empty before Stage::body.
std::vector<std::string> body_warnings(const Model& model, const BodyPlan& plan, Stage stage);

}  // namespace bodyline::model
