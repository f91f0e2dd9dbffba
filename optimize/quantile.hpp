#pragma once

#include <vector>

namespace bodyline::optimize {

/// The value below which a share of the values lies, 0 where there are none.
double quantile(std::vector<double> values, double share);

/// Root mean square of the smallest values, a share of all; 0 where there are none.
double trimmed_rms(std::vector<double> values, double share);

}  // namespace bodyline::optimize
