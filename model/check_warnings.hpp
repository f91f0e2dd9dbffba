#pragma once

#include <string>
#include <vector>

#include "model/body_plan.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// What a user should know of a body that is built as it should be, one sentence each: corner
/// patches that are not polynomial, and ends at which the transition of an uncut side does not
/// follow the free edge beyond, because that does not lead away from it (section 6). `base` and
/// `body` are the faces of these stages, in the order of BodyPlan::faces.
std::vector<std::string> body_warnings(const Model& model, const BodyPlan& plan,
                                       const std::vector<Surface>& base,
                                       const std::vector<Surface>& body);

}  // namespace bodyline::model
