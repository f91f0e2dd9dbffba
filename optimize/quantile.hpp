#pragma once

#include <vector>

namespace bodyline::optimize {

/// The value below which a share of the values lies, 0 where there are none. Here and below no
/// value may be NaN: they have no order.
double quantile(std::vector<double> values, double share);

/// The value in the middle; of an even number the upper one of the two.
double median(std::vector<double> values);

/// Root mean square of the smallest values, a share of all; 0 where there are none.
double trimmed_rms(std::vector<double> values, double share);

}  // namespace bodyline::optimize
