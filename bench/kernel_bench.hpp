#pragma once

#include "bench/report.hpp"

namespace bodyline::bench {

/// Registers the benchmarks of the kernels and of their peers on one bicubic patch with 8 x 8
/// nodes.
void register_kernel_benchmarks();

Report kernel_report();

}  // namespace bodyline::bench
