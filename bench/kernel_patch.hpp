#pragma once

#include <vector>

#include "model/face_rule.hpp"

namespace bodyline::bench {

/// A bicubic patch on an 8 x 8 Gauss rule, in the shape the peers take it: everything that is the
/// same for every net is computed before the clock starts, for all alike.
struct Patch {
  static constexpr int points = 4;  ///< per direction
  static constexpr int nodes = 8;   ///< per direction

  /// Derivatives of order a of B_i at node k: basis[k][a][i], the same along u and v.
  double basis[nodes][4][points];
  double parameters[nodes];
  double weights[nodes];
  std::vector<double> net;  ///< 4 x 4 x 3
};

/// A gently curved, twisted patch of about 1000 x 700 mm.
Patch bench_patch(const model::FaceTables& tables);

}  // namespace bodyline::bench
