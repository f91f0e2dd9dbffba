#pragma once

#include <span>

#include "model/family.hpp"

namespace bodyline::model {

/// What an end of a curve P_0..P_n of a family does with its control points. At t = 0
///   P' = d (P_1 - P_0),   P'' = a (P_0 - P_1) + b (P_2 - P_1),
/// and at t = 1 the same from the other end, with the sign of P' turned round. For the Bezier-like
/// family these are D, A and B, for H-Bezier k1, k2 and k3.
struct EndConstants {
  double d = 0.0, a = 0.0, b = 0.0;
};

/// `end` is 0 or 1. Meaningful for families with Family::joins.
EndConstants end_constants(const AnyBasis& basis, std::span<const double> shape, int end);
/// d end_constants / d shape[k].
EndConstants end_constants_derivative(const AnyBasis& basis, std::span<const double> shape, int end,
                                      int k);

}  // namespace bodyline::model
