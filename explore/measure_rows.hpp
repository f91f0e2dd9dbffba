#pragma once

#include <memory>

#include "explore/store_layout.hpp"
#include "explore/variant_evaluator.hpp"
#include "explore/variant_rows.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {

/// Measures the variants of rows whose values are set, and fills in everything else that the layout
/// keeps.
void measure_rows(VariantEvaluator& evaluator, VariantRows& rows);

/// Variants first to first + count - 1 of the source, measured.
std::shared_ptr<VariantRows> measure_range(VariantEvaluator& evaluator, const StoreLayout& layout,
                                           const VariantSource& source, std::uint64_t first,
                                           int count);

}  // namespace bodyline::explore
