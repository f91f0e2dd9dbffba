#pragma once

#include <string>

#include "model/model.hpp"

namespace bodyline::explore {

/// Whether two models differ in nothing but their numbers, so that their parameter vectors mean the
/// same: empty, or what differs, as "the patch \"hood\"".
std::string structural_difference(const model::Model& a, const model::Model& b);

}  // namespace bodyline::explore
