#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explore/metric_kind.hpp"
#include "explore/study.hpp"

namespace bodyline::explore {

/// "local", "nsga2", ...; optimizer_kind throws std::invalid_argument listing the names.
std::string optimizer_name(OptimizerKind kind);
OptimizerKind optimizer_kind(const std::string& name);

/// Whether it searches by gradients: local and front.
bool uses_gradients(OptimizerKind kind);

/// How many rows a study's optimizer makes, at most.
std::uint64_t planned_rows(const OptimizerSpec& optimizer, std::uint64_t starts);

}  // namespace bodyline::explore
