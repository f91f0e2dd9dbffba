#pragma once

#include "model/kernel_bicubic.hpp"
#include "model/kernel_contraction.hpp"
#include "model/kernel_lanes.hpp"
#include "model/kernels.hpp"

/// Nearest points of one face to given points, several points at once. See kernels_impl.cpp.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

constexpr int max_foot_degree = 12;

/// Bernstein polynomials of one degree and their first two derivatives, at one parameter a lane.
struct LaneBasis {
  Lanes value[max_foot_degree + 1], first[max_foot_degree + 1], second[max_foot_degree + 1];
};

// From degree `from` to the next, in place.
BODYLINE_INLINE void raise_bernstein(int from, Lanes t, Lanes s, Lanes* b) {
  b[from + 1] = t * b[from];
#pragma GCC unroll 4
  for (int k = from; k > 0; --k) b[k] = s * b[k] + t * b[k - 1];
  b[0] = s * b[0];
}

BODYLINE_INLINE void differences(int degree, const Lanes* lower, Lanes* out) {
  const Lanes n = broadcast(degree);
  out[0] = -n * lower[0];
#pragma GCC unroll 4
  for (int k = 1; k < degree; ++k) out[k] = n * (lower[k - 1] - lower[k]);
  out[degree] = n * lower[degree - 1];
}

BODYLINE_INLINE void lane_basis(int degree, Lanes t, LaneBasis& basis) {
  const Lanes s = 1.0 - t;
  Lanes* const b = basis.value;
  Lanes lower[max_foot_degree + 1];  // first derivatives, one degree lower
  b[0] = broadcast(1.0);
#pragma GCC unroll 4
  for (int k = 0; k < degree - 2; ++k) raise_bernstein(k, t, s, b);
  if (degree >= 2) {
    differences(degree - 1, b, lower);
    raise_bernstein(degree - 2, t, s, b);
    differences(degree, lower, basis.second);
  } else {
    basis.second[0] = basis.second[1] = Lanes{};
  }
  differences(degree, b, basis.first);
  raise_bernstein(degree - 1, t, s, b);
}

/// The jet to the order 1 or 2; what is above it stays zero.
template <int Order>
BODYLINE_INLINE LaneJet lane_jet(int degree_u, int degree_v, const double* net, Lanes u, Lanes v) {
  LaneBasis bu, bv;
  lane_basis(degree_u, u, bu);
  lane_basis(degree_v, v, bv);
  LaneJet jet{};
#pragma GCC unroll 4
  for (int i = 0; i <= degree_u; ++i) {
    const double* const row = net + 3 * i * (degree_v + 1);
    Vector r{}, rv{}, rvv{};
#pragma GCC unroll 4
    for (int j = 0; j <= degree_v; ++j) {
      const Vector p = held(broadcast_vector(row + 3 * j));
      accumulate(r, bv.value[j], p);
      accumulate(rv, bv.first[j], p);
      if constexpr (Order >= 2) accumulate(rvv, bv.second[j], p);
    }
    accumulate(jet.s, bu.value[i], r);
    accumulate(jet.sv, bu.value[i], rv);
    accumulate(jet.su, bu.first[i], r);
    if constexpr (Order >= 2) {
      accumulate(jet.svv, bu.value[i], rvv);
      accumulate(jet.suv, bu.first[i], rv);
      accumulate(jet.suu, bu.second[i], r);
    }
  }
  return jet;
}

/// Adds `blend` times the Gregory function g of section 8 to a jet; g = a(u) a(v) q(u, v) with
/// a(t) = t (1 - t)^2 and q = (u^2 - v^2) / (u^2 + v^2).
BODYLINE_INLINE void add_blend(const double* blend, Lanes u, Lanes v, LaneJet& jet) {
  const Lanes s = 1.0 / (u * u + v * v + 1e-60), s2 = s * s, s3 = s * s2;
  const Lanes uu = u * u, vv = v * v, uv = u * v;
  const Lanes q = (uu - vv) * s, q_u = 4.0 * uv * v * s2, q_v = -4.0 * uv * u * s2;
  const Lanes q_uu = 4.0 * vv * (vv - 3.0 * uu) * s3, q_uv = 8.0 * uv * (uu - vv) * s3,
              q_vv = -4.0 * uu * (uu - 3.0 * vv) * s3;
  const Lanes a = u * (1.0 - u) * (1.0 - u), b = v * (1.0 - v) * (1.0 - v);
  const Lanes a1 = (1.0 - u) * (1.0 - 3.0 * u), b1 = (1.0 - v) * (1.0 - 3.0 * v);
  const Lanes a2 = 6.0 * u - 4.0, b2 = 6.0 * v - 4.0;
  const Vector w = broadcast_vector(blend);
  accumulate(jet.s, a * b * q, w);
  accumulate(jet.su, b * (a1 * q + a * q_u), w);
  accumulate(jet.sv, a * (b1 * q + b * q_v), w);
  accumulate(jet.suu, b * (a2 * q + 2.0 * a1 * q_u + a * q_uu), w);
  accumulate(jet.suv, a1 * (b1 * q + b * q_v) + a * (b1 * q_u + b * q_uv), w);
  accumulate(jet.svv, a * (b2 * q + 2.0 * b1 * q_v + b * q_vv), w);
}

template <int Order>
BODYLINE_INLINE LaneJet lane_jet(int degree_u, int degree_v, const double* net, const double* blend,
                                 Lanes u, Lanes v) {
  LaneJet jet = lane_jet<Order>(degree_u, degree_v, net, u, v);
  if (blend) add_blend(blend, u, v, jet);
  return jet;
}

BODYLINE_INLINE Lanes clamped(Lanes x, double low, double high) {
  const Lanes l = broadcast(low), h = broadcast(high);
  x = x < l ? l : x;
  return x > h ? h : x;
}

/// One step of Newton's method on the squared distance, kept inside [0, 1]^2: a parameter that the
/// slope pushes out of its range stays at its end. Where the distance is not convex the step is
/// that of Gauss and Newton.
BODYLINE_INLINE void newton_step(const LaneJet& jet, const Vector& point, Lanes& u, Lanes& v) {
  constexpr double longest = 0.3;  // of a step; a face is hardly straighter than that
  constexpr double least = 1e-30;
  const Lanes zero{}, one = broadcast(1.0);
  const Vector r = jet.s - point;
  const Lanes gu = dot(r, jet.su), gv = dot(r, jet.sv);
  const Lanes e = dot(jet.su, jet.su) + least, f = dot(jet.su, jet.sv),
              g = dot(jet.sv, jet.sv) + least;
  Lanes a = e + dot(r, jet.suu), b = f + dot(r, jet.suv), c = g + dot(r, jet.svv);
  const Mask convex = (a > 0.1 * e) & (c > 0.1 * g) & (a * c - b * b > 0.01 * e * g);
  a = convex ? a : e;
  b = convex ? b : f;
  c = convex ? c : g;
  const Mask fix_u = ((u <= zero) & (gu > zero)) | ((u >= one) & (gu < zero));
  const Mask fix_v = ((v <= zero) & (gv > zero)) | ((v >= one) & (gv < zero));
  b = (fix_u | fix_v) ? zero : b;
  const Lanes det = a * c - b * b;
  const Lanes scale = 1.0 / (det > least ? det : broadcast(least));
  const Lanes du = (b * gv - c * gu) * scale, dv = (b * gu - a * gv) * scale;
  u = fix_u ? u : clamped(u + clamped(du, -longest, longest), 0.0, 1.0);
  v = fix_v ? v : clamped(v + clamped(dv, -longest, longest), 0.0, 1.0);
}

// jet(order, u, v) gives the jets of the face.
template <class FirstJet, class SecondJet>
BODYLINE_INLINE void foot_points_by(FirstJet first_jet, SecondJet second_jet, int steps,
                                    const FootPointArrays& a) {
  for (int k = 0; k < a.count; k += lanes) {
    const Vector point{load(a.x + k), load(a.y + k), load(a.z + k)};
    Lanes u = load(a.u + k), v = load(a.v + k);
    for (int step = 0; step < steps; ++step) newton_step(second_jet(u, v), point, u, v);
    const LaneJet jet = first_jet(u, v);
    store(a.u + k, u);
    store(a.v + k, v);
    const Vector n = cross(jet.su, jet.sv);
    const Lanes length2 = dot(n, n);
    const Lanes inverse = reciprocal_sqrt(length2 > 1e-200 ? length2 : broadcast(1e-200));
    const Vector out[2] = {jet.s, inverse * n};
    for (int q = 0; q < 2; ++q) {
      double* const* const to = q == 0 ? a.foot : a.normal;
      store(to[0] + k, out[q].x);
      store(to[1] + k, out[q].y);
      store(to[2] + k, out[q].z);
    }
  }
}

inline void foot_points(int degree_u, int degree_v, const double* net, const double* blend,
                        int steps, const FootPointArrays& a) {
  if (degree_u == 3 && degree_v == 3 && !blend) {
    const BicubicNet own = bicubic_net(net);
    foot_points_by([&](Lanes u, Lanes v) BODYLINE_INLINED { return bicubic_jet<1>(own, u, v); },
                   [&](Lanes u, Lanes v) BODYLINE_INLINED { return bicubic_jet<2>(own, u, v); },
                   steps, a);
    return;
  }
  foot_points_by([&](Lanes u, Lanes v)
                     BODYLINE_INLINED { return lane_jet<1>(degree_u, degree_v, net, blend, u, v); },
                 [&](Lanes u, Lanes v)
                     BODYLINE_INLINED { return lane_jet<2>(degree_u, degree_v, net, blend, u, v); },
                 steps, a);
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
