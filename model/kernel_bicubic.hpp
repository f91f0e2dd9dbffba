#pragma once

#include "model/kernel_lanes.hpp"

/// Jets of a bicubic face at one parameter a lane: most faces of a car are bicubic, and with the
/// differences of the net taken once nothing but registers is needed.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// Position and derivatives of a face at one parameter a lane.
struct LaneJet {
  Vector s, su, sv, suu, suv, svv;
};

/// Bernstein polynomials of degrees 3, 2 and 1 at one parameter a lane.
struct CubicBasis {
  Lanes cubic[4], square[3], linear[2];
};

BODYLINE_INLINE CubicBasis cubic_basis(Lanes t) {
  const Lanes s = 1.0 - t, ss = s * s, tt = t * t, st = s * t;
  return {{ss * s, 3.0 * st * s, 3.0 * st * t, tt * t}, {ss, 2.0 * st, tt}, {s, t}};
}

/// A bicubic net, component by component, and its scaled first and second differences along v.
struct BicubicNet {
  double value[3][4][4], slope[3][4][3], bend[3][4][2];
};

BODYLINE_INLINE BicubicNet bicubic_net(const double* net) {
  BicubicNet out;
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < 4; ++i) {
      double* const p = out.value[c][i];
      for (int j = 0; j < 4; ++j) p[j] = net[3 * (4 * i + j) + c];
      for (int j = 0; j < 3; ++j) out.slope[c][i][j] = 3.0 * (p[j + 1] - p[j]);
      for (int j = 0; j < 2; ++j) out.bend[c][i][j] = 6.0 * (p[j + 2] - 2.0 * p[j + 1] + p[j]);
    }
  }
  return out;
}

/// One component of a jet to the order 1 or 2.
template <int Order>
BODYLINE_INLINE void bicubic_component(const double (&value)[4][4], const double (&slope)[4][3],
                                       const double (&bend)[4][2], const CubicBasis& bu,
                                       const CubicBasis& bv, Lanes Vector::*c, LaneJet& jet) {
  Lanes row[4], row_v[4], row_vv[4];
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i) {
    row[i] = bv.cubic[0] * value[i][0] + bv.cubic[1] * value[i][1] + bv.cubic[2] * value[i][2] +
             bv.cubic[3] * value[i][3];
    row_v[i] = bv.square[0] * slope[i][0] + bv.square[1] * slope[i][1] + bv.square[2] * slope[i][2];
    if constexpr (Order >= 2) row_vv[i] = bv.linear[0] * bend[i][0] + bv.linear[1] * bend[i][1];
  }
  const auto cubic = [&](const Lanes* r) BODYLINE_INLINED {
    return bu.cubic[0] * r[0] + bu.cubic[1] * r[1] + bu.cubic[2] * r[2] + bu.cubic[3] * r[3];
  };
  const auto slope_u = [&](const Lanes* r) BODYLINE_INLINED {
    return 3.0 * (bu.square[0] * (r[1] - r[0]) + bu.square[1] * (r[2] - r[1]) +
                  bu.square[2] * (r[3] - r[2]));
  };
  jet.s.*c = cubic(row);
  jet.sv.*c = cubic(row_v);
  jet.su.*c = slope_u(row);
  if constexpr (Order >= 2) {
    jet.svv.*c = cubic(row_vv);
    jet.suv.*c = slope_u(row_v);
    jet.suu.*c = 6.0 * (bu.linear[0] * (row[2] - 2.0 * row[1] + row[0]) +
                        bu.linear[1] * (row[3] - 2.0 * row[2] + row[1]));
  }
}

template <int Order>
BODYLINE_INLINE LaneJet bicubic_jet(const BicubicNet& net, Lanes u, Lanes v) {
  const CubicBasis bu = cubic_basis(u), bv = cubic_basis(v);
  LaneJet jet{};
  constexpr Lanes Vector::*components[3] = {&Vector::x, &Vector::y, &Vector::z};
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c)
    bicubic_component<Order>(net.value[c], net.slope[c], net.bend[c], bu, bv, components[c], jet);
  return jet;
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
