#pragma once

#include "model/kernel_forms.hpp"

namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// |grad_S H|^2 |Su x Sv| (section 9). With A = G L - 2 F M + E N and D = |Su x Sv|^2, 2 H = A
/// D^(-3/2), so that 2 H_u = C_u D^(-3/2) with C_u = A_u - 3/2 A D_u / D, and the integrand is 1/4
/// D^(-7/2) (G C_u^2 - 2 F C_u C_v + E C_v^2).
struct Variation {
  static constexpr int order = 3;

  /// Derivatives of the two forms along one parameter.
  struct Slopes {
    Lanes e, f, g, l, m, n;
  };

  /// What value and pullback share.
  struct State {
    Forms x;
    Vector uv_uu, uv_vv, vv_uu;  ///< cross products of second derivatives
    Slopes u, v;
    Lanes du, dv;  ///< derivatives of D
    Lanes r, q;    ///< D^(-1/2), 1/D
    Lanes ratio;   ///< 3/2 A / D
    Lanes cu, cv;
  };

  BODYLINE_INLINE Lanes trace_slope(const Forms& x, const Slopes& s) {
    const Lanes fm = s.f * x.m + x.f * s.m;
    return s.g * x.l + x.g * s.l + s.e * x.n + x.e * s.n - (fm + fm);
  }
  BODYLINE_INLINE Lanes determinant_slope(const Forms& x, const Slopes& s) {
    return s.e * x.g + x.e * s.g - (x.f + x.f) * s.f;
  }
  BODYLINE_INLINE Lanes quadratic(const State& s) {
    return s.cu * (s.x.g * s.cu - (s.x.f + s.x.f) * s.cv) + s.x.e * (s.cv * s.cv);
  }

  BODYLINE_INLINE void first_form_slopes(const Jet& jet, State& s) {
    const Lanes u_uu = dot(jet.u, jet.uu), u_uv = dot(jet.u, jet.uv), u_vv = dot(jet.u, jet.vv);
    const Lanes v_uu = dot(jet.v, jet.uu), v_uv = dot(jet.v, jet.uv), v_vv = dot(jet.v, jet.vv);
    s.u.e = u_uu + u_uu;
    s.u.f = v_uu + u_uv;
    s.u.g = v_uv + v_uv;
    s.v.e = u_uv + u_uv;
    s.v.f = v_uv + u_vv;
    s.v.g = v_vv + v_vv;
  }

  /// Derivatives of normal . Suu and so on: triple products of first and second derivatives, and
  /// the normal with the third derivatives.
  BODYLINE_INLINE void second_form_slopes(const Jet& jet, State& s) {
    s.uv_uu = cross(jet.uv, jet.uu);
    s.uv_vv = cross(jet.uv, jet.vv);
    s.vv_uu = cross(jet.vv, jet.uu);
    const Lanes t_uuv = dot(s.x.normal, jet.uuv), t_uvv = dot(s.x.normal, jet.uvv);
    const Lanes v1 = dot(jet.v, s.uv_uu), u2 = dot(jet.u, s.uv_vv);
    s.u.l = dot(jet.u, s.uv_uu) + dot(s.x.normal, jet.uuu);
    s.u.m = v1 + t_uuv;
    s.u.n = dot(jet.v, s.vv_uu) + u2 + t_uvv;
    s.v.l = dot(jet.u, s.vv_uu) - v1 + t_uuv;
    s.v.m = t_uvv - u2;
    s.v.n = dot(s.x.normal, jet.vvv) - dot(jet.v, s.uv_vv);
  }

  BODYLINE_INLINE State state(const Jet& jet) {
    State s;
    s.x = forms(jet);
    first_form_slopes(jet, s);
    second_form_slopes(jet, s);
    s.r = reciprocal_sqrt(s.x.determinant);
    s.q = s.r * s.r;
    s.ratio = (1.5 * mixed_trace(s.x)) * s.q;
    s.du = determinant_slope(s.x, s.u);
    s.dv = determinant_slope(s.x, s.v);
    s.cu = trace_slope(s.x, s.u) - s.ratio * s.du;
    s.cv = trace_slope(s.x, s.v) - s.ratio * s.dv;
    return s;
  }

  /// 1/4 D^(-7/2).
  BODYLINE_INLINE Lanes scale(const State& s) { return 0.25 * (s.q * s.q) * (s.q * s.r); }

  BODYLINE_INLINE Lanes value(const Jet& jet) {
    const State s = state(jet);
    return scale(s) * quadratic(s);
  }

  /// Adjoints of the forms and of their slopes.
  struct FormsBar {
    Lanes e, f, g, l, m, n, d;
    Slopes u, v;
  };

  BODYLINE_INLINE void slopes_pullback(const Forms& x, const Slopes& s, Lanes c_bar, Lanes d_bar,
                                       FormsBar& bar, Slopes& slope_bar) {
    const Lanes c_bar2 = c_bar + c_bar, d_bar2 = d_bar + d_bar;
    slope_bar.e = c_bar * x.n + d_bar * x.g;
    slope_bar.f = -(c_bar2 * x.m + d_bar2 * x.f);
    slope_bar.g = c_bar * x.l + d_bar * x.e;
    slope_bar.l = c_bar * x.g;
    slope_bar.m = -(c_bar2 * x.f);
    slope_bar.n = c_bar * x.e;
    bar.e += c_bar * s.n + d_bar * s.g;
    bar.f -= c_bar2 * s.m + d_bar2 * s.f;
    bar.g += c_bar * s.l + d_bar * s.e;
    bar.l += c_bar * s.g;
    bar.m -= c_bar2 * s.f;
    bar.n += c_bar * s.e;
  }

  BODYLINE_INLINE FormsBar forms_pullback(const State& s, Lanes seed) {
    const Lanes k = seed * scale(s), k2 = k + k;
    const Lanes cu_bar = k2 * (s.x.g * s.cu - s.x.f * s.cv),
                cv_bar = k2 * (s.x.e * s.cv - s.x.f * s.cu);
    const Lanes ratio_bar = -(s.du * cu_bar + s.dv * cv_bar);
    const Lanes a_bar = (1.5 * s.q) * ratio_bar;
    FormsBar bar;
    bar.d = -s.q * (3.5 * (k * quadratic(s)) + ratio_bar * s.ratio);
    bar.e = k * (s.cv * s.cv) + a_bar * s.x.n;
    bar.f = -(k2 * (s.cu * s.cv) + (a_bar + a_bar) * s.x.m);
    bar.g = k * (s.cu * s.cu) + a_bar * s.x.l;
    bar.l = a_bar * s.x.g;
    bar.m = -(a_bar + a_bar) * s.x.f;
    bar.n = a_bar * s.x.e;
    slopes_pullback(s.x, s.u, cu_bar, -(s.ratio * cu_bar), bar, bar.u);
    slopes_pullback(s.x, s.v, cv_bar, -(s.ratio * cv_bar), bar, bar.v);
    return bar;
  }

  /// Adds what the first form and its slopes pass on.
  BODYLINE_INLINE void first_form_pullback(const Jet& jet, const FormsBar& form, Jet& bar) {
    const Lanes u_uu = form.u.e + form.u.e, v_uu = form.u.f, v_vv = form.v.g + form.v.g,
                u_vv = form.v.f;
    const Lanes u_uv = form.u.f + (form.v.e + form.v.e), v_uv = form.v.f + (form.u.g + form.u.g);
    bar.u = bar.u + (form.e + form.e) * jet.u + form.f * jet.v + u_uu * jet.uu + u_uv * jet.uv +
            u_vv * jet.vv;
    bar.v = bar.v + (form.g + form.g) * jet.v + form.f * jet.u + v_uu * jet.uu + v_uv * jet.uv +
            v_vv * jet.vv;
    bar.uu = bar.uu + u_uu * jet.u + v_uu * jet.v;
    bar.uv = bar.uv + u_uv * jet.u + v_uv * jet.v;
    bar.vv = bar.vv + u_vv * jet.u + v_vv * jet.v;
  }

  /// Sets `bar` to what the second form and its slopes pass on.
  BODYLINE_INLINE void second_form_pullback(const Jet& jet, const State& s, const FormsBar& form,
                                            Jet& bar) {
    const Lanes t_uuv = form.u.m + form.v.l, t_uvv = form.u.n + form.v.m;
    const Lanes v1 = form.u.m - form.v.l, u2 = form.u.n - form.v.m;
    const Vector uv_uu_bar = form.u.l * jet.u + v1 * jet.v;
    const Vector uv_vv_bar = u2 * jet.u - form.v.n * jet.v;
    const Vector vv_uu_bar = form.v.l * jet.u + form.u.n * jet.v;
    const Vector normal_bar = form.l * jet.uu + form.m * jet.uv + form.n * jet.vv +
                              form.u.l * jet.uuu + t_uuv * jet.uuv + t_uvv * jet.uvv +
                              form.v.n * jet.vvv + (form.d + form.d) * s.x.normal;
    bar.uuu = form.u.l * s.x.normal;
    bar.uuv = t_uuv * s.x.normal;
    bar.uvv = t_uvv * s.x.normal;
    bar.vvv = form.v.n * s.x.normal;
    bar.uu = form.l * s.x.normal + cross(uv_uu_bar, jet.uv) + cross(vv_uu_bar, jet.vv);
    bar.uv = form.m * s.x.normal + cross(jet.uu, uv_uu_bar) + cross(jet.vv, uv_vv_bar);
    bar.vv = form.n * s.x.normal + cross(uv_vv_bar, jet.uv) + cross(jet.uu, vv_uu_bar);
    bar.u = cross(jet.v, normal_bar) + form.u.l * s.uv_uu + u2 * s.uv_vv + form.v.l * s.vv_uu;
    bar.v = cross(normal_bar, jet.u) + v1 * s.uv_uu - form.v.n * s.uv_vv + form.u.n * s.vv_uu;
  }

  /// Returns the value; writes seed times its derivative to `bar`.
  BODYLINE_INLINE Lanes pullback(const Jet& jet, Lanes seed, Jet& bar) {
    const State s = state(jet);
    const FormsBar form = forms_pullback(s, seed);
    second_form_pullback(jet, s, form, bar);
    first_form_pullback(jet, form, bar);
    return scale(s) * quadratic(s);
  }
};

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
