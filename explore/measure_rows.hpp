#pragma once

#include "explore/store_layout.hpp"
#include "explore/variant_evaluator.hpp"
#include "explore/variant_rows.hpp"

namespace bodyline::explore {

/// Measures the variants of rows whose values are set, and fills in everything else that the layout
/// keeps.
void measure_rows(VariantEvaluator& evaluator, VariantRows& rows);

}  // namespace bodyline::explore
