#pragma once

#include <functional>

namespace bodyline::model {

/// A point of the unit square and a function's value there.
struct Extreme {
  double u = 0.0, v = 0.0;
  double value = 0.0;
};

/// The largest value of `f` on [0,1]^2 near the best point of a grid of (cells + 1)^2 points, found
/// by a pattern search that halves its step down to 1e-9: as good as rounding allows where f is
/// smooth. Points where f is NaN are passed over; the value is -infinity when all are.
Extreme largest_value(const std::function<double(double u, double v)>& f, int cells);

}  // namespace bodyline::model
