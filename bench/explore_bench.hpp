#pragma once

#include "bench/report.hpp"

namespace bodyline::bench {

/// Families of variants: measuring them on two threads, storing them, and what others do instead.
/// All on the study of 100 variables of examples/sweep.toml, whose metrics are bending and the
/// dimensions.
void register_explore_benchmarks();
Report explore_report();

}  // namespace bodyline::bench
