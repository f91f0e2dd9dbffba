#pragma once

#include "explore/study.hpp"

namespace bodyline::explore {

/// Checks that a study can be carried out: that its patterns and names match what the models have,
/// that ranges are not empty, that the sampler suits the space. Throws StudyError.
void check_study(const Study& study);

}  // namespace bodyline::explore
