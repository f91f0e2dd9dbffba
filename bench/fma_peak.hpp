#pragma once

#include "model/kernels.hpp"

namespace bodyline::bench {

/// Floating-point operations of one call of fma_peak.
double fma_peak_operations(model::Isa isa);

/// Independent chains of fused multiply-adds of one instruction set in registers: what a core can
/// do at most. The baseline has no fused operation and alternates products and sums. The result
/// only keeps the compiler from leaving the work out.
double fma_peak(model::Isa isa);

}  // namespace bodyline::bench
