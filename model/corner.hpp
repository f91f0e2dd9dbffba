#pragma once

#include "model/elevation.hpp"
#include "model/isa_namespace.hpp"
#include "model/plane_solve.hpp"
#include "model/vec3.hpp"

/// The corner patch where three or four transitions end: a bicubically blended Coons patch V(x, y),
/// G1 with all of them (docs/mathematics.md, section 7). D is the degree of the transitions across
/// their joints: 3, and then V is of degree (6,6), or 5 where a joint has continuity 2, and V of
/// degree (8,8).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// Degree of a corner patch, and its points, over edges of degree D.
constexpr int corner_degree(int d = 3) { return d + 3; }
constexpr int corner_points(int d = 3) { return (d + 4) * (d + 4); }

/// Edges of a corner patch: y = 0 and y = 1 run along x, x = 0 and x = 1 along y.
enum CornerEdge { bottom, top, left, right };

/// The end of one transition, in the direction of the corner patch's edge.
template <class Real, int D = 3>
struct TransitionEnd {
  Vec3<Real> curve[D + 1];   ///< the edge itself
  Vec3<Real> inward[D + 1];  ///< the transition's derivative along the joint, of degree D in the
                             ///< edge's parameter
};

/// Field across an edge: kappa(t) inward(t) + mu(t) curve'(t), kappa and mu cubic (Hermite data at
/// both ends).
template <class Real>
struct CornerField {
  PlaneCoordinates<Real> value[2];  ///< (kappa, mu) at t = 0 and 1
  PlaneCoordinates<Real> slope[2];
};

/// Everything the construction computed on its way, for the pullback. Fields are indexed by
/// CornerEdge.
template <class Real>
struct CornerTrace {
  CornerField<Real> field[4];
};

/// One corner of V: the edge along x that ends there, the edge along y, and which end of each.
struct CornerVertex {
  CornerEdge along_x, along_y;
  int x, y;  ///< 0 or 1
};
inline constexpr CornerVertex corner_vertices[4] = {
    {bottom, left, 0, 0}, {bottom, right, 1, 0}, {top, left, 0, 1}, {top, right, 1, 1}};

/// Value and derivatives of a transition end's curve and inward field at t = 0 or 1.
template <class Real>
struct EndJet {
  Vec3<Real> tangent, second;            ///< c', c''
  Vec3<Real> inward, inward_derivative;  ///< q, q'
};

template <class Real, int D>
EndJet<Real> end_jet(const TransitionEnd<Real, D>& edge, int end) {
  constexpr double first = D, second = D * (D - 1);
  const Vec3<Real>*c = edge.curve, *q = edge.inward;
  if (end == 0) {
    return {scaled(first, c[1] - c[0]), scaled(second, c[0] - scaled(2.0, c[1]) + c[2]), q[0],
            scaled(first, q[1] - q[0])};
  }
  return {scaled(first, c[D] - c[D - 1]), scaled(second, c[D - 2] - scaled(2.0, c[D - 1]) + c[D]),
          q[D], scaled(first, q[D] - q[D - 1])};
}

template <class Real, int D>
void end_jet_pullback(int end, const EndJet<Real>& bar, TransitionEnd<Real, D>& edge_bar) {
  constexpr double second = D * (D - 1);
  Vec3<Real>*c = edge_bar.curve, *q = edge_bar.inward;
  const int at = end == 0 ? 0 : D, next = end == 0 ? 1 : D - 1, after = end == 0 ? 2 : D - 2;
  const double first = end == 0 ? D : -D;
  c[next] += scaled(first, bar.tangent) - scaled(2.0 * second, bar.second);
  c[at] += scaled(second, bar.second) - scaled(first, bar.tangent);
  c[after] += scaled(second, bar.second);
  q[at] += bar.inward - scaled(first, bar.inward_derivative);
  q[next] += scaled(first, bar.inward_derivative);
}

/// Adjoints of the two end jets at a vertex.
template <class Real>
struct VertexBar {
  EndJet<Real> x, y;
};

/// The twist seen from one edge: the derivative of its field at an end.
template <class Real>
Vec3<Real> field_twist(const EndJet<Real>& jet, const PlaneCoordinates<Real>& value,
                       const PlaneCoordinates<Real>& slope) {
  return slope.p * jet.inward + value.p * jet.inward_derivative + slope.q * jet.tangent +
         value.q * jet.second;
}

template <class Real>
void field_twist_pullback(const EndJet<Real>& jet, const PlaneCoordinates<Real>& value,
                          const PlaneCoordinates<Real>& slope, const Vec3<Real>& bar,
                          EndJet<Real>& jet_bar, PlaneCoordinates<Real>& value_bar,
                          PlaneCoordinates<Real>& slope_bar) {
  slope_bar.p += dot(bar, jet.inward);
  slope_bar.q += dot(bar, jet.tangent);
  value_bar.p += dot(bar, jet.inward_derivative);
  value_bar.q += dot(bar, jet.second);
  jet_bar.inward += slope.p * bar;
  jet_bar.inward_derivative += value.p * bar;
  jet_bar.tangent += slope.q * bar;
  jet_bar.second += value.q * bar;
}

/// In the norm of the slopes kappa' counts 1 / kappa_ease = 5 times as much as mu': a steep kappa
/// falls below zero between the vertices, and the corner patch then turns back at the edge.
inline constexpr double kappa_ease = 0.2;

/// Field values at a regular vertex, and the four slopes (kappa', mu' of both edges) that make both
/// twists agree in the tangent plane with the least norm.
template <class Real>
void regular_vertex(const EndJet<Real>& x, const EndJet<Real>& y, PlaneCoordinates<Real>& x_value,
                    PlaneCoordinates<Real>& x_slope, PlaneCoordinates<Real>& y_value,
                    PlaneCoordinates<Real>& y_slope) {
  x_value = plane_solve(x.inward, x.tangent, y.tangent);
  y_value = plane_solve(y.inward, y.tangent, x.tangent);
  const PlaneCoordinates<Real> none{};
  const Vec3<Real> gap = field_twist(y, y_value, none) - field_twist(x, x_value, none);
  const Vec3<Real> column[4] = {scaled(kappa_ease, x.inward), x.tangent,
                                scaled(-kappa_ease, y.inward), -y.tangent};
  const Vec3<Real> axis[2] = {x.tangent, y.tangent};
  Real a[2][4], rhs[2];
  for (int r = 0; r < 2; ++r) {
    rhs[r] = dot(axis[r], gap);
    for (int k = 0; k < 4; ++k) a[r][k] = dot(axis[r], column[k]);
  }
  Real g00{}, g01{}, g11{};
  for (int k = 0; k < 4; ++k) {
    g00 += a[0][k] * a[0][k];
    g01 += a[0][k] * a[1][k];
    g11 += a[1][k] * a[1][k];
  }
  const Real inverse = Real(1.0) / (g00 * g11 - g01 * g01);
  const Real y0 = (g11 * rhs[0] - g01 * rhs[1]) * inverse,
             y1 = (g00 * rhs[1] - g01 * rhs[0]) * inverse;
  x_slope = {Real(kappa_ease) * (a[0][0] * y0 + a[1][0] * y1), a[0][1] * y0 + a[1][1] * y1};
  y_slope = {Real(kappa_ease) * (a[0][2] * y0 + a[1][2] * y1), a[0][3] * y0 + a[1][3] * y1};
}

/// Pullback of regular_vertex: adds to the adjoints of both end jets; the value adjoints are
/// consumed.
template <class Real>
void regular_vertex_pullback(
    const EndJet<Real>& x, const EndJet<Real>& y, const PlaneCoordinates<Real>& x_value,
    const PlaneCoordinates<Real>& y_value, PlaneCoordinates<Real> x_value_bar,
    const PlaneCoordinates<Real>& x_slope_bar, PlaneCoordinates<Real> y_value_bar,
    const PlaneCoordinates<Real>& y_slope_bar, EndJet<Real>& x_bar, EndJet<Real>& y_bar) {
  const PlaneCoordinates<Real> none{};
  const Vec3<Real> gap = field_twist(y, y_value, none) - field_twist(x, x_value, none);
  const Vec3<Real> column[4] = {scaled(kappa_ease, x.inward), x.tangent,
                                scaled(-kappa_ease, y.inward), -y.tangent};
  const Vec3<Real> axis[2] = {x.tangent, y.tangent};
  Real a[2][4], rhs[2];
  for (int r = 0; r < 2; ++r) {
    rhs[r] = dot(axis[r], gap);
    for (int k = 0; k < 4; ++k) a[r][k] = dot(axis[r], column[k]);
  }
  Real g00{}, g01{}, g11{};
  for (int k = 0; k < 4; ++k) {
    g00 += a[0][k] * a[0][k];
    g01 += a[0][k] * a[1][k];
    g11 += a[1][k] * a[1][k];
  }
  const Real inverse = Real(1.0) / (g00 * g11 - g01 * g01);
  const Real y0 = (g11 * rhs[0] - g01 * rhs[1]) * inverse,
             y1 = (g00 * rhs[1] - g01 * rhs[0]) * inverse;
  // z = A^T s, s = (A A^T)^-1 rhs
  const Real z_bar[4] = {Real(kappa_ease) * x_slope_bar.p, x_slope_bar.q,
                         Real(kappa_ease) * y_slope_bar.p, y_slope_bar.q};
  Real s0{}, s1{};
  for (int k = 0; k < 4; ++k) {
    s0 += a[0][k] * z_bar[k];
    s1 += a[1][k] * z_bar[k];
  }
  const Real w0 = (g11 * s0 - g01 * s1) * inverse, w1 = (g00 * s1 - g01 * s0) * inverse;
  Vec3<Real> column_bar[4], axis_bar[2] = {};
  for (int k = 0; k < 4; ++k) {
    const Real along_s = a[0][k] * y0 + a[1][k] * y1, along_w = a[0][k] * w0 + a[1][k] * w1;
    const Real a0_bar = y0 * z_bar[k] - w0 * along_s - y0 * along_w;
    const Real a1_bar = y1 * z_bar[k] - w1 * along_s - y1 * along_w;
    column_bar[k] = a0_bar * axis[0] + a1_bar * axis[1];
    axis_bar[0] += a0_bar * column[k];
    axis_bar[1] += a1_bar * column[k];
  }
  axis_bar[0] += w0 * gap;
  axis_bar[1] += w1 * gap;
  const Vec3<Real> gap_bar = w0 * axis[0] + w1 * axis[1];
  PlaneCoordinates<Real> unused;
  field_twist_pullback(y, y_value, none, gap_bar, y_bar, y_value_bar, unused);
  field_twist_pullback(x, x_value, none, -gap_bar, x_bar, x_value_bar, unused);
  x_bar.inward += scaled(kappa_ease, column_bar[0]);
  x_bar.tangent += column_bar[1] + axis_bar[0];
  y_bar.inward -= scaled(kappa_ease, column_bar[2]);
  y_bar.tangent += axis_bar[1] - column_bar[3];
  plane_solve_pullback(x.inward, x.tangent, y.tangent, x_value, x_value_bar, x_bar.inward,
                       x_bar.tangent, y_bar.tangent);
  plane_solve_pullback(y.inward, y.tangent, x.tangent, y_value, y_value_bar, y_bar.inward,
                       y_bar.tangent, x_bar.tangent);
}

/// The end tangents of the edges x = 0 and x = 1 at y = 1.
template <class Real>
struct ApexTangents {
  Vec3<Real> left, right;
};
template <class Real, int D>
ApexTangents<Real> apex_tangents(const TransitionEnd<Real, D>* edges) {
  return {scaled(double(D), edges[left].curve[D] - edges[left].curve[D - 1]),
          scaled(double(D), edges[right].curve[D] - edges[right].curve[D - 1])};
}

/// Where three joints meet the edge y = 1 shrinks to the apex: there the fields of the two long
/// edges vanish and their slopes make the twist equal to the difference of the two end tangents.
template <class Real>
struct ApexSlopes {
  PlaneCoordinates<Real> left, right;
};
template <class Real, int D>
ApexSlopes<Real> apex_slopes(const TransitionEnd<Real, D>* edges) {
  const EndJet<Real> l = end_jet(edges[left], 1), r = end_jet(edges[right], 1);
  const Vec3<Real> twist = r.tangent - l.tangent;
  return {plane_solve(l.inward, l.tangent, twist), plane_solve(r.inward, r.tangent, twist)};
}

/// Pullback of apex_slopes, to the jets of the left (x) and the right edge (y).
template <class Real, int D>
VertexBar<Real> apex_slopes_pullback(const TransitionEnd<Real, D>* edges,
                                     const ApexSlopes<Real>& slopes,
                                     const ApexSlopes<Real>& slopes_bar) {
  const EndJet<Real> l = end_jet(edges[left], 1), r = end_jet(edges[right], 1);
  const Vec3<Real> twist = r.tangent - l.tangent;
  VertexBar<Real> bar{};
  Vec3<Real> twist_bar{};
  plane_solve_pullback(l.inward, l.tangent, twist, slopes.left, slopes_bar.left, bar.x.inward,
                       bar.x.tangent, twist_bar);
  plane_solve_pullback(r.inward, r.tangent, twist, slopes.right, slopes_bar.right, bar.y.inward,
                       bar.y.tangent, twist_bar);
  bar.y.tangent += twist_bar;
  bar.x.tangent -= twist_bar;
  return bar;
}

/// The field as a row of degree D + 3: kappa q + mu c'.
template <class Real, int D>
void field_row(const TransitionEnd<Real, D>& edge, const CornerField<Real>& field,
               Vec3<Real>* row) {
  const PlaneCoordinates<Real>*v = field.value, *s = field.slope;
  const Real third(1.0 / 3.0);
  const Real kappa[4] = {v[0].p, v[0].p + third * s[0].p, v[1].p - third * s[1].p, v[1].p};
  const Real mu[4] = {v[0].q, v[0].q + third * s[0].q, v[1].q - third * s[1].q, v[1].q};
  Vec3<Real> tangent[D], along[D + 3], raised[D + 4];
  for (int i = 0; i < D; ++i) tangent[i] = scaled(double(D), edge.curve[i + 1] - edge.curve[i]);
  multiply<3, D - 1>(mu, tangent, along);
  elevate<D + 2, 1>(along, raised);
  multiply<3, D>(kappa, edge.inward, row);
  for (int k = 0; k < D + 4; ++k) row[k] += raised[k];
}

template <class Real, int D>
void field_row_pullback(const TransitionEnd<Real, D>& edge, const CornerField<Real>& field,
                        const Vec3<Real>* row_bar, TransitionEnd<Real, D>& edge_bar,
                        CornerField<Real>& field_bar) {
  const PlaneCoordinates<Real>*v = field.value, *s = field.slope;
  const Real third(1.0 / 3.0);
  const Real kappa[4] = {v[0].p, v[0].p + third * s[0].p, v[1].p - third * s[1].p, v[1].p};
  const Real mu[4] = {v[0].q, v[0].q + third * s[0].q, v[1].q - third * s[1].q, v[1].q};
  Vec3<Real> tangent[D], tangent_bar[D] = {}, along_bar[D + 3] = {};
  for (int i = 0; i < D; ++i) tangent[i] = scaled(double(D), edge.curve[i + 1] - edge.curve[i]);
  Real kappa_bar[4] = {}, mu_bar[4] = {};
  multiply_pullback<3, D>(kappa, edge.inward, row_bar, kappa_bar, edge_bar.inward);
  elevate_pullback<D + 2, 1>(row_bar, along_bar);
  multiply_pullback<3, D - 1>(mu, tangent, along_bar, mu_bar, tangent_bar);
  for (int i = 0; i < D; ++i) {
    edge_bar.curve[i + 1] += scaled(double(D), tangent_bar[i]);
    edge_bar.curve[i] -= scaled(double(D), tangent_bar[i]);
  }
  field_bar.value[0].p += kappa_bar[0] + kappa_bar[1];
  field_bar.value[1].p += kappa_bar[2] + kappa_bar[3];
  field_bar.slope[0].p += third * kappa_bar[1];
  field_bar.slope[1].p -= third * kappa_bar[2];
  field_bar.value[0].q += mu_bar[0] + mu_bar[1];
  field_bar.value[1].q += mu_bar[2] + mu_bar[3];
  field_bar.slope[0].q += third * mu_bar[1];
  field_bar.slope[1].q -= third * mu_bar[2];
}

/// Both twists at a vertex; they agree but for a normal part at the end of a seam.
template <class Real>
struct VertexTwist {
  Vec3<Real> from_x, from_y;
};

/// Sets the fields of both edges at a regular vertex; returns its twists.
template <class Real, int D>
VertexTwist<Real> vertex_fields(const TransitionEnd<Real, D>* edges, const CornerVertex& vertex,
                                CornerField<Real>* field) {
  const EndJet<Real> x = end_jet(edges[vertex.along_x], vertex.x),
                     y = end_jet(edges[vertex.along_y], vertex.y);
  CornerField<Real>&fx = field[vertex.along_x], &fy = field[vertex.along_y];
  regular_vertex(x, y, fx.value[vertex.x], fx.slope[vertex.x], fy.value[vertex.y],
                 fy.slope[vertex.y]);
  return {field_twist(x, fx.value[vertex.x], fx.slope[vertex.x]),
          field_twist(y, fy.value[vertex.y], fy.slope[vertex.y])};
}

/// Pullback of vertex_fields; adds the twists' part to `field_bar`.
template <class Real, int D>
VertexBar<Real> vertex_fields_pullback(const TransitionEnd<Real, D>* edges,
                                       const CornerVertex& vertex, const CornerField<Real>* field,
                                       const VertexTwist<Real>& twist_bar,
                                       CornerField<Real>* field_bar) {
  const EndJet<Real> x = end_jet(edges[vertex.along_x], vertex.x),
                     y = end_jet(edges[vertex.along_y], vertex.y);
  const CornerField<Real>&fx = field[vertex.along_x], &fy = field[vertex.along_y];
  CornerField<Real>&fx_bar = field_bar[vertex.along_x], &fy_bar = field_bar[vertex.along_y];
  VertexBar<Real> bar{};
  field_twist_pullback(x, fx.value[vertex.x], fx.slope[vertex.x], twist_bar.from_x, bar.x,
                       fx_bar.value[vertex.x], fx_bar.slope[vertex.x]);
  field_twist_pullback(y, fy.value[vertex.y], fy.slope[vertex.y], twist_bar.from_y, bar.y,
                       fy_bar.value[vertex.y], fy_bar.slope[vertex.y]);
  regular_vertex_pullback(x, y, fx.value[vertex.x], fy.value[vertex.y], fx_bar.value[vertex.x],
                          fx_bar.slope[vertex.x], fy_bar.value[vertex.y], fy_bar.slope[vertex.y],
                          bar.x, bar.y);
  return bar;
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
