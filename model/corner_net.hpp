#pragma once

#include "model/corner.hpp"

/// Assembling a corner patch's net from its edges (docs/mathematics.md, section 7).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// How many transitions meet, and whether a seam ends at the vertex (0,0).
struct CornerShape {
  bool three_sided = false;  ///< the edge `top` is the apex: all points of its curve are equal
  bool seam =
      false;  ///< the twists at (0,0) differ in their normal part: the face gets a Gregory term
};

/// Fields of all four edges. The top edge of a three-sided corner is V_y = (1-x) e_l + x e_r: not
/// stored as a field.
template <class Real>
void corner_fields(const CornerShape& shape, const TransitionEnd<Real>* edges,
                   CornerField<Real>* field) {
  for (const CornerVertex& vertex : corner_vertices) {
    if (shape.three_sided && vertex.y == 1) continue;
    const EndJet<Real> x = end_jet(edges[vertex.along_x], vertex.x),
                       y = end_jet(edges[vertex.along_y], vertex.y);
    CornerField<Real>&fx = field[vertex.along_x], &fy = field[vertex.along_y];
    regular_vertex(x, y, fx.value[vertex.x], fx.slope[vertex.x], fy.value[vertex.y],
                   fy.slope[vertex.y]);
  }
  if (shape.three_sided) apex_vertex(edges, field);
}

template <class Real>
void corner_fields_pullback(const CornerShape& shape, const TransitionEnd<Real>* edges,
                            const CornerField<Real>* field, const CornerField<Real>* field_bar,
                            TransitionEnd<Real>* edges_bar) {
  for (const CornerVertex& vertex : corner_vertices) {
    if (shape.three_sided && vertex.y == 1) continue;
    const EndJet<Real> x = end_jet(edges[vertex.along_x], vertex.x),
                       y = end_jet(edges[vertex.along_y], vertex.y);
    EndJet<Real> x_bar{}, y_bar{};
    const CornerField<Real>&fx = field[vertex.along_x], &fy = field[vertex.along_y];
    const CornerField<Real>&fx_bar = field_bar[vertex.along_x], &fy_bar = field_bar[vertex.along_y];
    regular_vertex_pullback(x, y, fx.value[vertex.x], fy.value[vertex.y], fx_bar.value[vertex.x],
                            fx_bar.slope[vertex.x], fy_bar.value[vertex.y], fy_bar.slope[vertex.y],
                            x_bar, y_bar);
    end_jet_pullback(vertex.x, x_bar, edges_bar[vertex.along_x]);
    end_jet_pullback(vertex.y, y_bar, edges_bar[vertex.along_y]);
  }
  if (shape.three_sided) apex_vertex_pullback(edges, field, field_bar, edges_bar);
}

/// Position in the bicubic patch W of the point that holds a vertex's twist, and of its three
/// neighbours.
struct TwistPlace {
  int at, along_x, along_y, vertex;  ///< indices [x * 4 + y]
  double sign;                       ///< of twist / 9
};
constexpr TwistPlace twist_place(const CornerVertex& vertex) {
  const int x = vertex.x == 0 ? 1 : 2, y = vertex.y == 0 ? 1 : 2;
  const int x0 = 3 * vertex.x, y0 = 3 * vertex.y;
  return {x * 4 + y, x * 4 + y0, x0 * 4 + y, x0 * 4 + y0, vertex.x == vertex.y ? 1.0 : -1.0};
}

/// The net (7 x 7, [x][y], y fastest) and the coefficient of the Gregory term of surface.hpp (zero
/// without a seam).
template <class Real>
void corner_net(const CornerShape& shape, const TransitionEnd<Real>* edges,
                CornerTrace<Real>& trace, Vec3<Real>* net, Vec3<Real>* blend) {
  corner_fields(shape, edges, trace.field);
  // W: bicubic patch of the corner data. [x][y]
  Vec3<Real> w[16];
  for (int k = 1; k < 3; ++k) {
    w[k * 4] = edges[bottom].curve[k];
    w[k * 4 + 3] = edges[top].curve[k];
  }
  for (int k = 0; k < 4; ++k) {
    w[k] = edges[left].curve[k];
    w[12 + k] = edges[right].curve[k];
  }
  const Vec3<Real> end_left = scaled(3.0, edges[left].curve[3] - edges[left].curve[2]);
  const Vec3<Real> end_right = scaled(3.0, edges[right].curve[3] - edges[right].curve[2]);
  *blend = Vec3<Real>{};
  for (const CornerVertex& vertex : corner_vertices) {
    Vec3<Real> twist;
    if (shape.three_sided && vertex.y == 1) {
      twist = end_right - end_left;
    } else {
      const VertexTwist<Real> both = vertex_twist(edges, trace.field, vertex);
      twist = scaled(0.5, both.from_x + both.from_y);
      if (shape.seam && vertex.x == 0 && vertex.y == 0)
        *blend = scaled(0.5, both.from_x - both.from_y);
    }
    const TwistPlace place = twist_place(vertex);
    w[place.at] =
        w[place.along_x] + w[place.along_y] - w[place.vertex] + scaled(place.sign / 9.0, twist);
  }
  // Inner rows in y of the patch that meets bottom and top, less W raised in x; whole rows in x for
  // left and right.
  Vec3<Real> inner[2][7], field[7], inner_w[2][4];
  field_row(edges[bottom], trace.field[bottom], field);
  for (int k = 0; k < 4; ++k) inner_w[0][k] = edges[bottom].curve[k] - w[k * 4 + 1];
  elevate<3, 3>(inner_w[0], inner[0]);
  for (int k = 0; k < 7; ++k) inner[0][k] += scaled(1.0 / 3.0, field[k]);
  if (shape.three_sided) {
    const Vec3<Real> ends[2] = {end_left, end_right};
    elevate<1, 5>(ends, field);
  } else {
    field_row(edges[top], trace.field[top], field);
  }
  for (int k = 0; k < 4; ++k) inner_w[1][k] = edges[top].curve[k] - w[k * 4 + 2];
  elevate<3, 3>(inner_w[1], inner[1]);
  for (int k = 0; k < 7; ++k) inner[1][k] -= scaled(1.0 / 3.0, field[k]);
  Vec3<Real> raised_left[7], raised_right[7], field_right[7];
  elevate<3, 3>(edges[left].curve, raised_left);
  elevate<3, 3>(edges[right].curve, raised_right);
  field_row(edges[left], trace.field[left], field);
  field_row(edges[right], trace.field[right], field_right);
  for (int l = 0; l < 7; ++l) {
    const Vec3<Real> across[4] = {raised_left[l], raised_left[l] + scaled(1.0 / 3.0, field[l]),
                                  raised_right[l] - scaled(1.0 / 3.0, field_right[l]),
                                  raised_right[l]};
    Vec3<Real> column[7];
    elevate<3, 3>(across, column);
    for (int k = 0; k < 7; ++k) net[k * 7 + l] = column[k];
  }
  for (int k = 0; k < 7; ++k) {
    Vec3<Real>* row = net + k * 7;
    unrolled<1, 4>([&](auto l) { row[l] += scaled(elevation<3, 3>.weight[l][1], inner[0][k]); });
    unrolled<2, 5>([&](auto l) { row[l] += scaled(elevation<3, 3>.weight[l][2], inner[1][k]); });
  }
}

/// Pullback of corner_net: adds to the adjoints of the edges.
template <class Real>
void corner_net_pullback(const CornerShape& shape, const TransitionEnd<Real>* edges,
                         const CornerTrace<Real>& trace, const Vec3<Real>* net_bar,
                         const Vec3<Real>& blend_bar, TransitionEnd<Real>* edges_bar) {
  Vec3<Real> inner_bar[2][7], left_bar[7], right_bar[7], field_bar[7], field_right_bar[7],
      w_bar[16] = {};
  for (int k = 0; k < 7; ++k) {
    const Vec3<Real>* row_bar = net_bar + k * 7;
    Vec3<Real> first{}, second{};
    unrolled<1, 4>([&](auto l) { first += scaled(elevation<3, 3>.weight[l][1], row_bar[l]); });
    unrolled<2, 5>([&](auto l) { second += scaled(elevation<3, 3>.weight[l][2], row_bar[l]); });
    inner_bar[0][k] = first;
    inner_bar[1][k] = second;
  }
  for (int l = 0; l < 7; ++l) {
    Vec3<Real> column_bar[7], across_bar[4] = {};
    for (int k = 0; k < 7; ++k) column_bar[k] = net_bar[k * 7 + l];
    elevate_pullback<3, 3>(column_bar, across_bar);
    left_bar[l] = across_bar[0] + across_bar[1];
    right_bar[l] = across_bar[3] + across_bar[2];
    field_bar[l] = scaled(1.0 / 3.0, across_bar[1]);
    field_right_bar[l] = scaled(-1.0 / 3.0, across_bar[2]);
  }
  CornerField<Real> fields_bar[4] = {};
  field_row_pullback(edges[left], trace.field[left], field_bar, edges_bar[left], fields_bar[left]);
  field_row_pullback(edges[right], trace.field[right], field_right_bar, edges_bar[right],
                     fields_bar[right]);
  elevate_pullback<3, 3>(left_bar, edges_bar[left].curve);
  elevate_pullback<3, 3>(right_bar, edges_bar[right].curve);
  for (int side = 0; side < 2; ++side) {
    Vec3<Real> inner_w_bar[4] = {};
    elevate_pullback<3, 3>(inner_bar[side], inner_w_bar);
    for (int k = 0; k < 4; ++k) {
      edges_bar[side == 0 ? bottom : top].curve[k] += inner_w_bar[k];
      w_bar[k * 4 + 1 + side] -= inner_w_bar[k];
    }
  }
  for (int k = 0; k < 7; ++k) field_bar[k] = scaled(1.0 / 3.0, inner_bar[0][k]);
  field_row_pullback(edges[bottom], trace.field[bottom], field_bar, edges_bar[bottom],
                     fields_bar[bottom]);
  for (int k = 0; k < 7; ++k) field_bar[k] = scaled(-1.0 / 3.0, inner_bar[1][k]);
  Vec3<Real> ends_bar[2] = {};  // of the two end tangents at an apex
  if (shape.three_sided) {
    elevate_pullback<1, 5>(field_bar, ends_bar);
  } else {
    field_row_pullback(edges[top], trace.field[top], field_bar, edges_bar[top], fields_bar[top]);
  }
  for (int v = 3; v >= 0; --v) {
    const CornerVertex& vertex = corner_vertices[v];
    const TwistPlace place = twist_place(vertex);
    const Vec3<Real> bar = w_bar[place.at];
    w_bar[place.along_x] += bar;
    w_bar[place.along_y] += bar;
    w_bar[place.vertex] -= bar;
    const Vec3<Real> twist_bar = scaled(place.sign / 9.0, bar);
    if (shape.three_sided && vertex.y == 1) {
      ends_bar[1] += twist_bar;
      ends_bar[0] -= twist_bar;
      continue;
    }
    VertexTwist<Real> both{scaled(0.5, twist_bar), scaled(0.5, twist_bar)};
    if (shape.seam && vertex.x == 0 && vertex.y == 0) {
      both.from_x += scaled(0.5, blend_bar);
      both.from_y -= scaled(0.5, blend_bar);
    }
    vertex_twist_pullback(edges, trace.field, vertex, both, edges_bar, fields_bar);
  }
  for (int side = 0; side < 2; ++side) {
    Vec3<Real>* curve_bar = edges_bar[side == 0 ? left : right].curve;
    curve_bar[3] += scaled(3.0, ends_bar[side]);
    curve_bar[2] -= scaled(3.0, ends_bar[side]);
  }
  for (int k = 0; k < 4; ++k) {
    edges_bar[left].curve[k] += w_bar[k];
    edges_bar[right].curve[k] += w_bar[12 + k];
  }
  for (int k = 1; k < 3; ++k) {
    edges_bar[bottom].curve[k] += w_bar[k * 4];
    edges_bar[top].curve[k] += w_bar[k * 4 + 3];
  }
  corner_fields_pullback(shape, edges, trace.field, fields_bar, edges_bar);
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
