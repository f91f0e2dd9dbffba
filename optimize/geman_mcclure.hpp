#pragma once

namespace bodyline::optimize {

/// The weight of Geman and McClure in a robust sum of squares, of a squared distance: 1 at 0, a
/// quarter at `reach`, less and less beyond.
inline double geman_mcclure(double squared, double reach) {
  const double ratio = 1.0 + squared / (reach * reach);
  return 1.0 / (ratio * ratio);
}

}  // namespace bodyline::optimize
