#pragma once

#include "model/corner_fields.hpp"

/// Assembling a corner patch's net from its edges (docs/mathematics.md, section 7).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// The cubic with a curve's points and tangents at both ends; the curve itself when D is 3.
template <int D, class Real>
void end_cubic(const Vec3<Real>* curve, Vec3<Real>* cubic) {
  if constexpr (D == 3) {
    for (int k = 0; k < 4; ++k) cubic[k] = curve[k];
  } else {
    constexpr double reach = D / 3.0;
    cubic[0] = curve[0];
    cubic[1] = curve[0] + scaled(reach, curve[1] - curve[0]);
    cubic[2] = curve[D] + scaled(reach, curve[D - 1] - curve[D]);
    cubic[3] = curve[D];
  }
}

/// Pullback of end_cubic: adds to curve_bar.
template <int D, class Real>
void end_cubic_pullback(const Vec3<Real>* cubic_bar, Vec3<Real>* curve_bar) {
  if constexpr (D == 3) {
    for (int k = 0; k < 4; ++k) curve_bar[k] += cubic_bar[k];
  } else {
    constexpr double reach = D / 3.0;
    curve_bar[0] += cubic_bar[0] + scaled(1.0 - reach, cubic_bar[1]);
    curve_bar[1] += scaled(reach, cubic_bar[1]);
    curve_bar[D - 1] += scaled(reach, cubic_bar[2]);
    curve_bar[D] += cubic_bar[3] + scaled(1.0 - reach, cubic_bar[2]);
  }
}

/// An edge along x less the row of W beside it, as a row of degree D + 3.
template <int D, class Real>
void edge_less_w(const Vec3<Real>* curve, const Vec3<Real>* w_row, Vec3<Real>* row) {
  if constexpr (D == 3) {
    Vec3<Real> difference[4];
    for (int k = 0; k < 4; ++k) difference[k] = curve[k] - w_row[k];
    elevate<3, 3>(difference, row);
  } else {
    Vec3<Real> raised[D + 4];
    elevate<D, 3>(curve, row);
    elevate<3, D>(w_row, raised);
    for (int k = 0; k < D + 4; ++k) row[k] -= raised[k];
  }
}

/// Pullback of edge_less_w: adds to both adjoints.
template <int D, class Real>
void edge_less_w_pullback(const Vec3<Real>* row_bar, Vec3<Real>* curve_bar, Vec3<Real>* w_row_bar) {
  if constexpr (D == 3) {
    Vec3<Real> difference_bar[4] = {};
    elevate_pullback<3, 3>(row_bar, difference_bar);
    for (int k = 0; k < 4; ++k) {
      curve_bar[k] += difference_bar[k];
      w_row_bar[k] -= difference_bar[k];
    }
  } else {
    Vec3<Real> raised_bar[4] = {};
    elevate_pullback<D, 3>(row_bar, curve_bar);
    elevate_pullback<3, D>(row_bar, raised_bar);
    for (int k = 0; k < 4; ++k) w_row_bar[k] -= raised_bar[k];
  }
}

/// The net ((D + 4) x (D + 4), [x][y], y fastest) and the coefficient of the Gregory term of
/// surface.hpp, which counts only where a seam ends at the vertex (0,0).
template <class Real, int D>
void corner_net(const CornerMix<Real>& mix, const TransitionEnd<Real, D>* edges,
                CornerTrace<Real>& trace, Vec3<Real>* net, Vec3<Real>* blend) {
  constexpr int points = D + 4;
  VertexTwist<Real> twist[4];
  corner_fields(mix, edges, trace.field, twist);
  *blend = scaled(0.5, twist[0].from_x - twist[0].from_y);
  // W: bicubic patch of the corner data. [x][y]
  Vec3<Real> w[16], top_row[D + 1], along_bottom[4], along_top[4];
  top_curve(mix, edges, top_row);
  end_cubic<D>(edges[bottom].curve, along_bottom);
  end_cubic<D>(top_row, along_top);
  for (int k = 1; k < 3; ++k) {
    w[k * 4] = along_bottom[k];
    w[k * 4 + 3] = along_top[k];
  }
  end_cubic<D>(edges[left].curve, w);
  end_cubic<D>(edges[right].curve, w + 12);
  for (int v = 0; v < 4; ++v) {
    const TwistPlace place = twist_place(corner_vertices[v]);
    w[place.at] = w[place.along_x] + w[place.along_y] - w[place.vertex] +
                  scaled(place.sign / 18.0, twist[v].from_x + twist[v].from_y);
  }
  // Rows in y of the patch that meets bottom and top, less W raised in x: the inner two, and where
  // the edges are no cubics also the outer ones; whole rows in x for left and right.
  Vec3<Real> inner[2][points], field[points], w_row[4];
  const auto take_w_row = [&](int y) {
    for (int k = 0; k < 4; ++k) w_row[k] = w[k * 4 + y];
  };
  field_row(edges[bottom], trace.field[bottom], field);
  take_w_row(1);
  edge_less_w<D>(edges[bottom].curve, w_row, inner[0]);
  for (int k = 0; k < points; ++k) inner[0][k] += scaled(1.0 / 3.0, field[k]);
  top_field_row(mix, edges, trace.field, field);
  take_w_row(2);
  edge_less_w<D>(top_row, w_row, inner[1]);
  for (int k = 0; k < points; ++k) inner[1][k] -= scaled(1.0 / 3.0, field[k]);
  Vec3<Real> raised_left[points], raised_right[points], field_right[points];
  elevate<D, 3>(edges[left].curve, raised_left);
  elevate<D, 3>(edges[right].curve, raised_right);
  field_row(edges[left], trace.field[left], field);
  field_row(edges[right], trace.field[right], field_right);
  for (int l = 0; l < points; ++l) {
    const Vec3<Real> across[4] = {raised_left[l], raised_left[l] + scaled(1.0 / 3.0, field[l]),
                                  raised_right[l] - scaled(1.0 / 3.0, field_right[l]),
                                  raised_right[l]};
    Vec3<Real> column[points];
    elevate<3, D>(across, column);
    for (int k = 0; k < points; ++k) net[k * points + l] = column[k];
  }
  for (int k = 0; k < points; ++k) {
    Vec3<Real>* row = net + k * points;
    unrolled<1, D + 1>(
        [&](auto l) { row[l] += scaled(elevation<3, D>.weight[l][1], inner[0][k]); });
    unrolled<2, D + 2>(
        [&](auto l) { row[l] += scaled(elevation<3, D>.weight[l][2], inner[1][k]); });
  }
  if constexpr (D > 3) {
    Vec3<Real> outer[2][points];
    take_w_row(0);
    edge_less_w<D>(edges[bottom].curve, w_row, outer[0]);
    take_w_row(3);
    edge_less_w<D>(top_row, w_row, outer[1]);
    for (int k = 0; k < points; ++k) {
      Vec3<Real>* row = net + k * points;
      unrolled<0, D>([&](auto l) { row[l] += scaled(elevation<3, D>.weight[l][0], outer[0][k]); });
      unrolled<3, D + 3>(
          [&](auto l) { row[l] += scaled(elevation<3, D>.weight[l][3], outer[1][k]); });
    }
  }
}

/// Pullback of corner_net: adds to the adjoints of the edges.
template <class Real, int D>
void corner_net_pullback(const CornerMix<Real>& mix, const TransitionEnd<Real, D>* edges,
                         const CornerTrace<Real>& trace, const Vec3<Real>* net_bar,
                         const Vec3<Real>& blend_bar, TransitionEnd<Real, D>* edges_bar) {
  constexpr int points = D + 4;
  Vec3<Real> inner_bar[2][points], left_bar[points], right_bar[points], field_bar[points],
      field_right_bar[points], w_bar[16] = {}, top_bar[D + 1] = {};
  for (int k = 0; k < points; ++k) {
    const Vec3<Real>* row_bar = net_bar + k * points;
    Vec3<Real> first{}, second{};
    unrolled<1, D + 1>([&](auto l) { first += scaled(elevation<3, D>.weight[l][1], row_bar[l]); });
    unrolled<2, D + 2>([&](auto l) { second += scaled(elevation<3, D>.weight[l][2], row_bar[l]); });
    inner_bar[0][k] = first;
    inner_bar[1][k] = second;
  }
  for (int l = 0; l < points; ++l) {
    Vec3<Real> column_bar[points], across_bar[4] = {};
    for (int k = 0; k < points; ++k) column_bar[k] = net_bar[k * points + l];
    elevate_pullback<3, D>(column_bar, across_bar);
    left_bar[l] = across_bar[0] + across_bar[1];
    right_bar[l] = across_bar[3] + across_bar[2];
    field_bar[l] = scaled(1.0 / 3.0, across_bar[1]);
    field_right_bar[l] = scaled(-1.0 / 3.0, across_bar[2]);
  }
  CornerField<Real> fields_bar[4] = {};
  field_row_pullback(edges[left], trace.field[left], field_bar, edges_bar[left], fields_bar[left]);
  field_row_pullback(edges[right], trace.field[right], field_right_bar, edges_bar[right],
                     fields_bar[right]);
  elevate_pullback<D, 3>(left_bar, edges_bar[left].curve);
  elevate_pullback<D, 3>(right_bar, edges_bar[right].curve);
  const auto add_w_row = [&](int y, const Vec3<Real>* w_row_bar) {
    for (int k = 0; k < 4; ++k) w_bar[k * 4 + y] += w_row_bar[k];
  };
  for (int side = 0; side < 2; ++side) {
    Vec3<Real> w_row_bar[4] = {};
    edge_less_w_pullback<D>(inner_bar[side], side == 0 ? edges_bar[bottom].curve : top_bar,
                            w_row_bar);
    add_w_row(1 + side, w_row_bar);
  }
  if constexpr (D > 3) {
    for (int side = 0; side < 2; ++side) {
      Vec3<Real> outer_bar[points], w_row_bar[4] = {};
      for (int k = 0; k < points; ++k) {
        const Vec3<Real>* row_bar = net_bar + k * points;
        Vec3<Real> sum{};
        for (int l = 0; l <= D; ++l) {
          const int at = side == 0 ? l : l + 3;
          sum += scaled(elevation<3, D>.weight[at][3 * side], row_bar[at]);
        }
        outer_bar[k] = sum;
      }
      edge_less_w_pullback<D>(outer_bar, side == 0 ? edges_bar[bottom].curve : top_bar, w_row_bar);
      add_w_row(3 * side, w_row_bar);
    }
  }
  for (int k = 0; k < points; ++k) field_bar[k] = scaled(1.0 / 3.0, inner_bar[0][k]);
  field_row_pullback(edges[bottom], trace.field[bottom], field_bar, edges_bar[bottom],
                     fields_bar[bottom]);
  for (int k = 0; k < points; ++k) field_bar[k] = scaled(-1.0 / 3.0, inner_bar[1][k]);
  ApexTangents<Real> ends_bar{};
  top_field_row_pullback(mix, edges, trace.field, field_bar, ends_bar, edges_bar, fields_bar);
  VertexTwist<Real> twist_bar[4];
  for (int v = 3; v >= 0; --v) {
    const TwistPlace place = twist_place(corner_vertices[v]);
    const Vec3<Real> bar = w_bar[place.at];
    w_bar[place.along_x] += bar;
    w_bar[place.along_y] += bar;
    w_bar[place.vertex] -= bar;
    twist_bar[v].from_x = twist_bar[v].from_y = scaled(place.sign / 18.0, bar);
  }
  twist_bar[0].from_x += scaled(0.5, blend_bar);
  twist_bar[0].from_y -= scaled(0.5, blend_bar);
  end_cubic_pullback<D>(w_bar, edges_bar[left].curve);
  end_cubic_pullback<D>(w_bar + 12, edges_bar[right].curve);
  Vec3<Real> bottom_w_bar[4] = {}, top_w_bar[4] = {};
  for (int k = 1; k < 3; ++k) {
    bottom_w_bar[k] = w_bar[k * 4];
    top_w_bar[k] = w_bar[k * 4 + 3];
  }
  end_cubic_pullback<D>(bottom_w_bar, edges_bar[bottom].curve);
  end_cubic_pullback<D>(top_w_bar, top_bar);
  corner_fields_pullback(mix, edges, trace.field, fields_bar, twist_bar, ends_bar, edges_bar);
  top_curve_pullback(mix, top_bar, edges_bar);
  edges_bar[left].curve[D] += scaled(double(D), ends_bar.left);
  edges_bar[left].curve[D - 1] -= scaled(double(D), ends_bar.left);
  edges_bar[right].curve[D] += scaled(double(D), ends_bar.right);
  edges_bar[right].curve[D - 1] -= scaled(double(D), ends_bar.right);
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
