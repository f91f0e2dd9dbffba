#pragma once

namespace bodyline::optimize {

/// How far points are heeded, mm.
struct PullReach {
  double normal = 0.0;  ///< off the surface: points so far away count a quarter
  double rim = 0.0;     ///< beyond a rim of the body, likewise
};

}  // namespace bodyline::optimize
