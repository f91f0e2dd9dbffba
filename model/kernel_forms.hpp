#pragma once

#include "model/kernel_contraction.hpp"

/// First and second fundamental form at the nodes. L, M, N are taken with the normal at its full
/// length, so that no division is needed until the end.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

struct Forms {
  Vector normal;      ///< Su x Sv
  Lanes determinant;  ///< |normal|^2 = EG - F^2
  Lanes e, f, g;
  Lanes l, m, n;  ///< normal . Suu, normal . Suv, normal . Svv
};

BODYLINE_INLINE Forms forms(const Jet& jet) {
  Forms x;
  x.normal = cross(jet.u, jet.v);
  x.determinant = dot(x.normal, x.normal);
  x.e = dot(jet.u, jet.u);
  x.f = dot(jet.u, jet.v);
  x.g = dot(jet.v, jet.v);
  x.l = dot(x.normal, jet.uu);
  x.m = dot(x.normal, jet.uv);
  x.n = dot(x.normal, jet.vv);
  return x;
}

/// G L - 2 F M + E N = 2 H |normal|^3.
BODYLINE_INLINE Lanes mixed_trace(const Forms& x) {
  return x.g * x.l + (x.e * x.n - (x.f + x.f) * x.m);
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
