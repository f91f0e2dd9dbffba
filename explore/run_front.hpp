#pragma once

#include "explore/variant_recorder.hpp"

namespace bodyline::explore {

/// Traces the front of a study's two objectives by their gradients; every point is a row.
RunProgress run_front(const std::shared_ptr<const VariantPlan>& plan, VariantRecorder& recorder);

}  // namespace bodyline::explore
