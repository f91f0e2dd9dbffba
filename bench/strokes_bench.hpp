#pragma once

#include "bench/report.hpp"

namespace bodyline::bench {

/// Surfaces from 1000 strokes, by both methods.
void register_strokes_benchmarks();
Report strokes_report();

}  // namespace bodyline::bench
