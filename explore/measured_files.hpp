#pragma once

#include <vector>

#include "explore/study.hpp"

namespace bodyline::explore {

/// The scans and drawings that a study's metrics measure against, in their order, each once, as
/// they are now. One that cannot be read has no digest; VariantPlan says why.
std::vector<MeasuredFile> measured_files(const Study& study);

}  // namespace bodyline::explore
