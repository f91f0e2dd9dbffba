#pragma once

#include <memory>

#include "explore/variant_plan.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {

/// The variants of a study with the optimizer `local`: row i is what a search by gradients finds
/// from start i of the study's sampler, as minimal as the weighted sum of its goals gets within the
/// bounds and constraints. It is never worse than its start: neither less usable (valid, then
/// infeasible, folded, not to be built), nor breaking constraints by more, nor with a larger sum.
std::unique_ptr<VariantSource> tuned_source(std::shared_ptr<const VariantPlan> plan);

/// All variants of a study that do not depend on each other's results: those of its sampler, or
/// tuned ones.
std::unique_ptr<VariantSource> plan_source(const std::shared_ptr<const VariantPlan>& plan);

}  // namespace bodyline::explore
