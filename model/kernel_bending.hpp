#pragma once

#include "model/kernel_forms.hpp"

namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// (k1^2 + k2^2) |Su x Sv| = (A^2 / D - 2 B) D^(-3/2) with A = G L - 2 F M + E N, B = L N - M^2 and
/// D = |Su x Sv|^2 (section 9).
struct Bending {
  static constexpr int order = 2;

  BODYLINE_INLINE Lanes value(const Jet& jet) {
    const Forms x = forms(jet);
    const Lanes a = mixed_trace(x);
    const Lanes b = x.l * x.n - x.m * x.m;
    const Lanes r = reciprocal_sqrt(x.determinant);
    const Lanes q = r * r;
    return (a * (a * q) - (b + b)) * (r * q);
  }

  /// Returns the value; writes seed times its derivative to `bar`.
  BODYLINE_INLINE Lanes pullback(const Jet& jet, Lanes seed, Jet& bar) {
    const Forms x = forms(jet);
    const Lanes a = mixed_trace(x);
    const Lanes b = x.l * x.n - x.m * x.m;
    const Lanes r = reciprocal_sqrt(x.determinant);
    const Lanes q = r * r, r3 = r * q, aq = a * q;
    const Lanes k = (seed + seed) * r3;
    const Lanes a_bar = k * aq, a_bar2 = a_bar + a_bar;
    const Lanes l_bar = a_bar * x.g - k * x.n;
    const Lanes m_bar = (k + k) * x.m - a_bar2 * x.f;
    const Lanes n_bar = a_bar * x.e - k * x.l;
    const Lanes d_bar2 = (k * q) * (3.0 * b - 2.5 * (a * aq));
    const Lanes f_bar = -(a_bar2 * x.m);
    const Vector normal_bar = l_bar * jet.uu + m_bar * jet.uv + n_bar * jet.vv + d_bar2 * x.normal;
    bar.uu = l_bar * x.normal;
    bar.uv = m_bar * x.normal;
    bar.vv = n_bar * x.normal;
    bar.u = cross(jet.v, normal_bar) + (a_bar2 * x.n) * jet.u + f_bar * jet.v;
    bar.v = cross(normal_bar, jet.u) + (a_bar2 * x.l) * jet.v + f_bar * jet.u;
    return (a * aq - (b + b)) * r3;
  }
};

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
