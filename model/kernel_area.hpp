#pragma once

#include "model/kernel_contraction.hpp"

namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// |Su x Sv|.
struct Area {
  static constexpr int order = 1;

  BODYLINE_INLINE Lanes value(const Jet& jet) {
    const Vector normal = cross(jet.u, jet.v);
    const Lanes determinant = dot(normal, normal);
    return determinant * reciprocal_sqrt(determinant);
  }

  /// Returns the value; writes seed times its derivative to `bar`.
  BODYLINE_INLINE Lanes pullback(const Jet& jet, Lanes seed, Jet& bar) {
    const Vector normal = cross(jet.u, jet.v);
    const Lanes determinant = dot(normal, normal);
    const Lanes r = reciprocal_sqrt(determinant);
    const Vector normal_bar = (seed * r) * normal;
    bar.u = cross(jet.v, normal_bar);
    bar.v = cross(normal_bar, jet.u);
    return determinant * r;
  }
};

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
