#pragma once

#include "bench/report.hpp"

namespace bodyline::bench {

/// Fitting to scans: foot points of 4096 points of one patch, and an iteration over a million.
void register_fit_benchmarks();
Report fit_report();

}  // namespace bodyline::bench
