#pragma once

#include "bench/report.hpp"

namespace bodyline::bench {

/// Registers the benchmarks of the whole body of model 1: all faces, 8 x 8 nodes on each, all
/// variables; and of the whole tuning of it.
void register_body_benchmarks();

Report body_report();

}  // namespace bodyline::bench
