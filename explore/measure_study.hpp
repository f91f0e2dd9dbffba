#pragma once

#include <functional>
#include <memory>

#include "explore/variant_plan.hpp"
#include "explore/variant_rows.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {

/// Measures all variants of a source on so many threads and hands their rows on in order, by one
/// thread at a time, some 64 at once; for those who keep them elsewhere than in a store.
void measure_study(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& source,
                   int threads, const std::function<void(const VariantRows&)>& take);

}  // namespace bodyline::explore
