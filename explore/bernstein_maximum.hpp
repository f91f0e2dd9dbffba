#pragma once

#include "model/bernstein.hpp"

namespace bodyline::explore {

/// A polynomial of two parameters in Bernstein form: coefficient (i, j) at i * (degree_v + 1) + j.
struct BernsteinPatch {
  static constexpr int most = (model::max_degree + 1) * (model::max_degree + 1);
  int degree_u = 0, degree_v = 0;
  double c[most];
};

/// The largest of `best` and of the patch's values on [0,1]^2, found to 1e-7: no value of the patch
/// is larger by more.
double maximum(const BernsteinPatch& patch, double best);

}  // namespace bodyline::explore
