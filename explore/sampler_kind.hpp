#pragma once

#include <string>
#include <vector>

#include "explore/study.hpp"

namespace bodyline::explore {

/// "sobol", ...; sampler_kind throws std::invalid_argument listing the names.
std::string sampler_name(SamplerKind kind);
SamplerKind sampler_kind(const std::string& name);

}  // namespace bodyline::explore
