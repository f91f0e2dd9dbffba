#pragma once

#include "model/kernel_contraction.hpp"

/// Transposes of kernel_contraction.hpp: jet adjoints -> row adjoints -> net adjoint.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

constexpr int block =
    8;  ///< nodes along v whose jet adjoints are held at a time; divides rule.nodes

/// Adjoints of the jets at `block` neighbouring nodes along v.
struct JetBlock {
  Jet jets[block];
};

/// For `count` neighbouring v indices adds to the row adjoints of one u-order: sum over the block's
/// nodes of the given jet entries, each times basis_v of one more order, starting from the order
/// `basis` points at.
template <int Order, int count, Vector Jet::*... entries>
BODYLINE_INLINE void transpose_entries(const double* basis, int nodes, int order_stride,
                                       const JetBlock& jets, bool fresh, Lanes* rows) {
  Vector total[count];
  for (int j = 0; j < count; ++j)
    total[j] = fresh ? Vector{} : load_vector(rows + j * Rows<Order>::stride);
  for (int k = 0; k < block; ++k) {
    const double* b = basis + k;
    const auto add = [&](const Vector& entry) {
      const Vector d = held(entry);
      for (int j = 0; j < count; ++j) accumulate(total[j], held(broadcast(b[j * nodes])), d);
      b += order_stride;
    };
    (add(jets.jets[k].*entries), ...);
  }
  for (int j = 0; j < count; ++j) store_vector(rows + j * Rows<Order>::stride, total[j]);
}

template <int Order, int count>
BODYLINE_INLINE void transpose_columns(const double* basis, int nodes, int order_stride,
                                       const JetBlock& jets, bool fresh, Lanes* rows) {
  // No energy depends on the point itself, so the first row starts from the first derivative of the
  // basis.
  const double* slope = basis + order_stride;
  if constexpr (Order == 1) {
    transpose_entries<1, count, &Jet::v>(slope, nodes, order_stride, jets, fresh, rows);
    transpose_entries<1, count, &Jet::u>(basis, nodes, order_stride, jets, fresh, rows + 3);
  } else if constexpr (Order == 2) {
    transpose_entries<2, count, &Jet::v, &Jet::vv>(slope, nodes, order_stride, jets, fresh, rows);
    transpose_entries<2, count, &Jet::u, &Jet::uv>(basis, nodes, order_stride, jets, fresh,
                                                   rows + 3);
    transpose_entries<2, count, &Jet::uu>(basis, nodes, order_stride, jets, fresh, rows + 6);
  } else {
    transpose_entries<3, count, &Jet::v, &Jet::vv, &Jet::vvv>(slope, nodes, order_stride, jets,
                                                              fresh, rows);
    transpose_entries<3, count, &Jet::u, &Jet::uv, &Jet::uvv>(basis, nodes, order_stride, jets,
                                                              fresh, rows + 3);
    transpose_entries<3, count, &Jet::uu, &Jet::uuv>(basis, nodes, order_stride, jets, fresh,
                                                     rows + 6);
    transpose_entries<3, count, &Jet::uuu>(basis, nodes, order_stride, jets, fresh, rows + 9);
  }
}

/// Adds the adjoints of the jets at nodes kv .. kv + block - 1 to those of the rows; the first
/// block sets them.
template <int Order>
BODYLINE_INLINE void contract_v_transposed(const FaceRule& rule, int kv, const JetBlock& jets,
                                           Rows<Order>& rows_bar) {
  const bool fresh = kv == 0;
  const int nodes = rule.nodes, points_v = rule.degree_v + 1, order_stride = points_v * nodes;
  constexpr int stride = Rows<Order>::stride;
  int j = 0;
  for (; j + 4 <= points_v; j += 4) {
    transpose_columns<Order, 4>(rule.basis_v + j * nodes + kv, nodes, order_stride, jets, fresh,
                                rows_bar.data + j * stride);
  }
  if (j + 2 <= points_v) {
    transpose_columns<Order, 2>(rule.basis_v + j * nodes + kv, nodes, order_stride, jets, fresh,
                                rows_bar.data + j * stride);
    j += 2;
  }
  if (j < points_v) {
    transpose_columns<Order, 1>(rule.basis_v + j * nodes + kv, nodes, order_stride, jets, fresh,
                                rows_bar.data + j * stride);
  }
}

/// Adjoint of the net before the sum over the lanes; laid out like the net.
struct NetLanes {
  Lanes data[3 * most_points * most_points];
};

/// Adds the row adjoints of nodes ku .. to those of the net; the first chunk sets them.
template <int Order>
BODYLINE_INLINE void contract_u_transposed(const FaceRule& rule, int ku,
                                           const Rows<Order>& rows_bar, NetLanes& net_bar) {
  const int points_u = rule.degree_u + 1, points_v = rule.degree_v + 1, nodes = rule.nodes;
  const int order_stride = points_u * nodes;
  const bool fresh = ku == 0;
  for (int j = 0; j < points_v; ++j) {
    const Lanes* row = rows_bar.data + j * Rows<Order>::stride;
    const Vector d0 = held(load_vector(row)), d1 = held(load_vector(row + 3));
    Vector d2, d3;
    if constexpr (Order >= 2) d2 = held(load_vector(row + 6));
    if constexpr (Order >= 3) d3 = held(load_vector(row + 9));
    const double* basis = rule.basis_u + ku;
    Lanes* bar = net_bar.data + 3 * j;
    for (int i = 0; i < points_u; ++i, basis += nodes, bar += 3 * points_v) {
      Vector total = fresh ? Vector{} : load_vector(bar);
      accumulate(total, held(load(basis)), d0);
      accumulate(total, held(load(basis + order_stride)), d1);
      if constexpr (Order >= 2) accumulate(total, held(load(basis + 2 * order_stride)), d2);
      if constexpr (Order >= 3) accumulate(total, held(load(basis + 3 * order_stride)), d3);
      store_vector(bar, total);
    }
  }
}

/// Adds the sums over the lanes to the caller's net adjoint of `size` numbers.
BODYLINE_INLINE void add_sums(const NetLanes& net_lanes, int size, double* net_bar) {
  int first = 0;
  for (; first + lanes <= size; first += lanes) {
    store(net_bar + first, load(net_bar + first) + sums(net_lanes.data + first));
  }
  for (; first < size; ++first) net_bar[first] += sum(net_lanes.data[first]);
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
