#pragma once

#include "model/corner.hpp"
#include "model/where.hpp"

/// Shape of a corner patch, and the fields across its edges (docs/mathematics.md, section 7).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// How many transitions meet, and whether a seam ends at the vertex (0,0).
struct CornerShape {
  bool three_sided = false;  ///< the edge `top` is the apex: all points of its curve are equal
  bool seam =
      false;  ///< the twists at (0,0) differ in their normal part: the face gets a Gregory term
};

/// Which lanes of a number type hold three-sided corners. There the edge `top` holds any regular
/// edge instead of the apex, so that the steps of four sides can be taken in all lanes; their
/// results are not used.
template <class Real>
struct CornerMix {
  bool some = false, all = false;  ///< lanes that are three-sided
  Real apex{};                     ///< 1 in those lanes, else 0
};

/// The case of one lane.
template <class Real>
CornerMix<Real> corner_mix(const CornerShape& shape) {
  return {shape.three_sided, shape.three_sided, Real(shape.three_sided ? 1.0 : 0.0)};
}

/// `apex` in three-sided lanes, else `regular`. A choice, not a product: what is not chosen may be
/// infinite.
template <class Real>
Vec3<Real> choose(const CornerMix<Real>& mix, const Vec3<Real>& apex, const Vec3<Real>& regular) {
  if (!mix.some) return regular;
  if (mix.all) return apex;
  const auto number = [&](const Real& yes, const Real& no) {
    return where_at_least(mix.apex, Real(0.5), yes, no);
  };
  return {number(apex.x, regular.x), number(apex.y, regular.y), number(apex.z, regular.z)};
}
template <class Real>
PlaneCoordinates<Real> choose(const CornerMix<Real>& mix, const PlaneCoordinates<Real>& apex,
                              const PlaneCoordinates<Real>& regular) {
  if (!mix.some) return regular;
  if (mix.all) return apex;
  return {where_at_least(mix.apex, Real(0.5), apex.p, regular.p),
          where_at_least(mix.apex, Real(0.5), apex.q, regular.q)};
}
template <class Real>
EndJet<Real> choose(const CornerMix<Real>& mix, const EndJet<Real>& apex,
                    const EndJet<Real>& regular) {
  return {choose(mix, apex.tangent, regular.tangent), choose(mix, apex.second, regular.second),
          choose(mix, apex.inward, regular.inward),
          choose(mix, apex.inward_derivative, regular.inward_derivative)};
}

/// Whether a vertex is a regular one in any lane.
template <class Real>
bool has_regular(const CornerMix<Real>& mix, const CornerVertex& vertex) {
  return vertex.y == 0 || !mix.all;
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

/// Fields of all four edges, and the twists at the four vertices. The top edge of a three-sided
/// corner has the field V_y = (1-x) e_l + x e_r, which is not stored.
template <class Real, int D>
void corner_fields(const CornerMix<Real>& mix, const TransitionEnd<Real, D>* edges,
                   CornerField<Real>* field, VertexTwist<Real>* twist) {
  for (int v = 0; v < 4; ++v) {
    if (has_regular(mix, corner_vertices[v]))
      twist[v] = vertex_fields(edges, corner_vertices[v], field);
  }
  if (!mix.some) return;
  const ApexSlopes<Real> slopes = apex_slopes(edges);
  const ApexTangents<Real> ends = apex_tangents(edges);
  const PlaneCoordinates<Real> none{};
  for (const CornerEdge e : {left, right}) {
    field[e].value[1] = choose(mix, none, field[e].value[1]);
    field[e].slope[1] = choose(mix, e == left ? slopes.left : slopes.right, field[e].slope[1]);
  }
  for (int v = 2; v < 4; ++v) {
    const Vec3<Real> apex = ends.right - ends.left;
    twist[v] = {choose(mix, apex, twist[v].from_x), choose(mix, apex, twist[v].from_y)};
  }
}

/// Pullback of corner_fields: adds to the adjoints of the end tangents and of the edges; consumes
/// both others.
template <class Real, int D>
void corner_fields_pullback(const CornerMix<Real>& mix, const TransitionEnd<Real, D>* edges,
                            const CornerField<Real>* field, CornerField<Real>* field_bar,
                            VertexTwist<Real>* twist_bar, ApexTangents<Real>& ends_bar,
                            TransitionEnd<Real, D>* edges_bar) {
  const Vec3<Real> zero{};
  const EndJet<Real> no_jet{};
  for (int v = 2; mix.some && v < 4; ++v) {
    const Vec3<Real> apex = choose(mix, twist_bar[v].from_x + twist_bar[v].from_y, zero);
    ends_bar.right += apex;
    ends_bar.left -= apex;
    twist_bar[v] = {choose(mix, zero, twist_bar[v].from_x), choose(mix, zero, twist_bar[v].from_y)};
  }
  for (int v = 0; v < 4; ++v) {
    const CornerVertex& vertex = corner_vertices[v];
    if (!has_regular(mix, vertex)) continue;
    VertexBar<Real> bar = vertex_fields_pullback(edges, vertex, field, twist_bar[v], field_bar);
    if (vertex.y == 1) bar = {choose(mix, no_jet, bar.x), choose(mix, no_jet, bar.y)};
    end_jet_pullback(vertex.x, bar.x, edges_bar[vertex.along_x]);
    end_jet_pullback(vertex.y, bar.y, edges_bar[vertex.along_y]);
  }
  if (!mix.some) return;
  const VertexBar<Real> bar =
      apex_slopes_pullback(edges, ApexSlopes<Real>{field[left].slope[1], field[right].slope[1]},
                           {field_bar[left].slope[1], field_bar[right].slope[1]});
  end_jet_pullback(1, choose(mix, bar.x, no_jet), edges_bar[left]);
  end_jet_pullback(1, choose(mix, bar.y, no_jet), edges_bar[right]);
}

/// The curve of the top edge: the apex in three-sided lanes.
template <class Real, int D>
void top_curve(const CornerMix<Real>& mix, const TransitionEnd<Real, D>* edges, Vec3<Real>* curve) {
  for (int t = 0; t <= D; ++t) curve[t] = choose(mix, edges[left].curve[D], edges[top].curve[t]);
}

template <class Real, int D>
void top_curve_pullback(const CornerMix<Real>& mix, const Vec3<Real>* curve_bar,
                        TransitionEnd<Real, D>* edges_bar) {
  const Vec3<Real> zero{};
  for (int t = 0; t <= D; ++t) {
    edges_bar[left].curve[D] += choose(mix, curve_bar[t], zero);
    edges_bar[top].curve[t] += choose(mix, zero, curve_bar[t]);
  }
}

/// The field across the top edge as a row of degree D + 3.
template <class Real, int D>
void top_field_row(const CornerMix<Real>& mix, const TransitionEnd<Real, D>* edges,
                   const CornerField<Real>* field, Vec3<Real>* row) {
  if (!mix.all) field_row(edges[top], field[top], row);
  if (!mix.some) return;
  const ApexTangents<Real> ends = apex_tangents(edges);
  const Vec3<Real> linear[2] = {ends.left, ends.right};
  Vec3<Real> apex[D + 4];
  elevate<1, D + 2>(linear, apex);
  for (int k = 0; k < D + 4; ++k) row[k] = choose(mix, apex[k], row[k]);
}

template <class Real, int D>
void top_field_row_pullback(const CornerMix<Real>& mix, const TransitionEnd<Real, D>* edges,
                            const CornerField<Real>* field, const Vec3<Real>* row_bar,
                            ApexTangents<Real>& ends_bar, TransitionEnd<Real, D>* edges_bar,
                            CornerField<Real>* field_bar) {
  const Vec3<Real> zero{};
  Vec3<Real> part_bar[D + 4];
  if (!mix.all) {
    for (int k = 0; k < D + 4; ++k) part_bar[k] = choose(mix, zero, row_bar[k]);
    field_row_pullback(edges[top], field[top], part_bar, edges_bar[top], field_bar[top]);
  }
  if (!mix.some) return;
  for (int k = 0; k < D + 4; ++k) part_bar[k] = choose(mix, row_bar[k], zero);
  Vec3<Real> linear_bar[2] = {};
  elevate_pullback<1, D + 2>(part_bar, linear_bar);
  ends_bar.left += linear_bar[0];
  ends_bar.right += linear_bar[1];
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
