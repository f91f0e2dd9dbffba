#pragma once

#include "model/kernel_lanes.hpp"
#include "model/kernels.hpp"

/// Sum factorisation of a Bezier net: first along u (net -> rows, one for each v index), then along
/// v (rows -> jet at a node). `Order` is the highest derivative, 1 to 3.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

constexpr int most_points = 13;  ///< control points per direction

/// Derivatives at `lanes` nodes; a kernel touches only those up to its order.
struct Jet {
  Vector u, v, uu, uv, vv, uuu, uuv, uvv, vvv;
};

/// Calls visit(jet_index, derivative) for the derivatives of order 1 to `Order`.
template <int Order, class Visit>
BODYLINE_INLINE void for_each_derivative(Jet& jet, Visit visit) {
  visit(1, jet.u);
  visit(2, jet.v);
  if constexpr (Order >= 2) {
    visit(3, jet.uu);
    visit(4, jet.uv);
    visit(5, jet.vv);
  }
  if constexpr (Order >= 3) {
    visit(6, jet.uuu);
    visit(7, jet.uuv);
    visit(8, jet.uvv);
    visit(9, jet.vvv);
  }
}

/// Nets contracted along u: at data + (j * (Order + 1) + a) * 3 stands the a-th u-derivative, at
/// `lanes` nodes, of the curve with the control points net[.][j].
template <int Order>
struct Rows {
  static constexpr int stride = 3 * (Order + 1);
  Lanes data[most_points * stride];
};

BODYLINE_INLINE void accumulate(Vector& total, Lanes factor, const Vector& a) {
  total.x += factor * a.x;
  total.y += factor * a.y;
  total.z += factor * a.z;
}

/// Rows of the nodes ku .. ku + lanes - 1.
template <int Order>
BODYLINE_INLINE void contract_u(const FaceRule& rule, int ku, const double* net,
                                Rows<Order>& rows) {
  const int points_u = rule.degree_u + 1, points_v = rule.degree_v + 1, nodes = rule.nodes;
  const int order_stride = points_u * nodes;
  for (int j = 0; j < points_v; ++j) {
    Vector d0{}, d1{}, d2{}, d3{};
    const double* basis = rule.basis_u + ku;
    const double* p = net + 3 * j;
    for (int i = 0; i < points_u; ++i, basis += nodes, p += 3 * points_v) {
      const Vector point = held(broadcast_vector(p));
      accumulate(d0, held(load(basis)), point);
      accumulate(d1, held(load(basis + order_stride)), point);
      if constexpr (Order >= 2) accumulate(d2, held(load(basis + 2 * order_stride)), point);
      if constexpr (Order >= 3) accumulate(d3, held(load(basis + 3 * order_stride)), point);
    }
    Lanes* row = rows.data + j * Rows<Order>::stride;
    store_vector(row, d0);
    store_vector(row + 3, d1);
    if constexpr (Order >= 2) store_vector(row + 6, d2);
    if constexpr (Order >= 3) store_vector(row + 9, d3);
  }
}

/// Jet entry q of the Gregory function at the nodes (ku .., kv).
BODYLINE_INLINE Lanes blend_table(const FaceRule& rule, int q, int kv, int ku) {
  return load(rule.blend + (q * rule.nodes + kv) * rule.nodes + ku);
}

/// What contract_v adds to: nothing, or the Gregory term.
template <int Order>
BODYLINE_INLINE void start_jet(const FaceRule& rule, const double* blend, int kv, int ku,
                               Jet& jet) {
  if (rule.blend == nullptr) {
    for_each_derivative<Order>(jet, [](int, Vector& d) { d = Vector{}; });
  } else {
    const Vector coefficient = broadcast_vector(blend);
    for_each_derivative<Order>(
        jet, [&](int q, Vector& d) { d = blend_table(rule, q, kv, ku) * coefficient; });
  }
}

/// The derivatives at node kv of the rows' nodes ku ..; the point itself, which no energy needs, is
/// left out.
template <int Order>
BODYLINE_INLINE Jet contract_v(const FaceRule& rule, const Rows<Order>& rows, const double* blend,
                               int kv, int ku) {
  Jet jet;
  start_jet<Order>(rule, blend, kv, ku, jet);
  const int order_stride = (rule.degree_v + 1) * rule.nodes;
  const double* basis = rule.basis_v + kv;
  const Lanes* row = rows.data;
  for (int j = 0; j <= rule.degree_v; ++j, basis += rule.nodes, row += Rows<Order>::stride) {
    const Lanes b0 = held(broadcast(basis[0])), b1 = held(broadcast(basis[order_stride]));
    const Vector d0 = held(load_vector(row)), d1 = held(load_vector(row + 3));
    accumulate(jet.v, b1, d0);
    accumulate(jet.u, b0, d1);
    if constexpr (Order >= 2) {
      const Lanes b2 = held(broadcast(basis[2 * order_stride]));
      const Vector d2 = held(load_vector(row + 6));
      accumulate(jet.vv, b2, d0);
      accumulate(jet.uv, b1, d1);
      accumulate(jet.uu, b0, d2);
      if constexpr (Order >= 3) {
        const Lanes b3 = held(broadcast(basis[3 * order_stride]));
        accumulate(jet.vvv, b3, d0);
        accumulate(jet.uvv, b2, d1);
        accumulate(jet.uuv, b1, d2);
        accumulate(jet.uuu, b0, load_vector(row + 9));
      }
    }
  }
  return jet;
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
