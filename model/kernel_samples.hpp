#pragma once

#include "model/kernel_forms.hpp"

/// Kernels that write a value for every node.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// Nodes along v that are written together: as many as leave room in the registers.
constexpr int group = lanes == 8 ? 8 : 4;

/// Derivative (a, b) = jet entry q at the nodes (ku .., kv .. kv + group - 1), all three
/// coordinates, `plane` apart.
template <int Order, int a, int b>
BODYLINE_INLINE void write_entry(const FaceRule& rule, const Rows<Order>& rows, const double* blend,
                                 int kv, int ku, double* out) {
  constexpr int q = (a + b) * (a + b + 1) / 2 + b;
  const int nodes = rule.nodes, plane = nodes * nodes, points_v = rule.degree_v + 1;
  Vector total[group];
  for (int k = 0; k < group; ++k) {
    total[k] = Vector{};
    if (rule.blend != nullptr) {
      total[k] = blend_table(rule, q, kv + k, ku) * broadcast_vector(blend);
    }
  }
  const double* basis = rule.basis_v + b * points_v * nodes + kv;
  const Lanes* row = rows.data + 3 * a;
  for (int j = 0; j < points_v; ++j, basis += nodes, row += Rows<Order>::stride) {
    const Vector d = held(load_vector(row));
    for (int k = 0; k < group; ++k) accumulate(total[k], held(broadcast(basis[k])), d);
  }
  double* node = out + 3 * q * plane + kv * nodes + ku;
  for (int k = 0; k < group; ++k) store(node + k * nodes, total[k].x);
  for (int k = 0; k < group; ++k) store(node + plane + k * nodes, total[k].y);
  for (int k = 0; k < group; ++k) store(node + 2 * plane + k * nodes, total[k].z);
}

/// All jet entries with a derivatives along u, for nets of points_v columns whose rows fit into the
/// registers.
template <int Order, int a, int points_v>
BODYLINE_INLINE void write_column(const FaceRule& rule, const double* net, const double* blend,
                                  int ku, double* out) {
  const int nodes = rule.nodes, plane = nodes * nodes, points_u = rule.degree_u + 1;
  Vector row[points_v];
  for (int j = 0; j < points_v; ++j) row[j] = Vector{};
  const double* basis_u = rule.basis_u + a * points_u * nodes + ku;
  for (int i = 0; i < points_u; ++i, basis_u += nodes, net += 3 * points_v) {
    const Lanes basis = held(load(basis_u));
    for (int j = 0; j < points_v; ++j) accumulate(row[j], basis, broadcast_vector(net + 3 * j));
  }
  for (int b = 0; a + b <= Order; ++b) {
    const int q = (a + b) * (a + b + 1) / 2 + b;
    const double* basis_v = rule.basis_v + b * points_v * nodes;
    double* entry = out + 3 * q * plane + ku;
    for (int kv = 0; kv < nodes; ++kv, ++basis_v, entry += nodes) {
      Vector total{};
      if (rule.blend != nullptr) total = blend_table(rule, q, kv, ku) * broadcast_vector(blend);
      for (int j = 0; j < points_v; ++j)
        accumulate(total, held(broadcast(basis_v[j * nodes])), row[j]);
      store(entry, total.x);
      store(entry + plane, total.y);
      store(entry + 2 * plane, total.z);
    }
  }
}

template <int Order, int points_v>
void jets_in_registers(const FaceRule& rule, const double* net, const double* blend, double* out) {
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    write_column<Order, 0, points_v>(rule, net, blend, ku, out);
    write_column<Order, 1, points_v>(rule, net, blend, ku, out);
    if constexpr (Order >= 2) write_column<Order, 2, points_v>(rule, net, blend, ku, out);
    if constexpr (Order >= 3) write_column<Order, 3, points_v>(rule, net, blend, ku, out);
  }
}

template <int Order>
void jets_in_memory(const FaceRule& rule, const double* net, const double* blend, double* out) {
  Rows<Order> rows;
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    contract_u<Order>(rule, ku, net, rows);
    for (int kv = 0; kv < rule.nodes; kv += group) {
      write_entry<Order, 0, 0>(rule, rows, blend, kv, ku, out);
      write_entry<Order, 1, 0>(rule, rows, blend, kv, ku, out);
      write_entry<Order, 0, 1>(rule, rows, blend, kv, ku, out);
      if constexpr (Order >= 2) {
        write_entry<Order, 2, 0>(rule, rows, blend, kv, ku, out);
        write_entry<Order, 1, 1>(rule, rows, blend, kv, ku, out);
        write_entry<Order, 0, 2>(rule, rows, blend, kv, ku, out);
      }
      if constexpr (Order >= 3) {
        write_entry<Order, 3, 0>(rule, rows, blend, kv, ku, out);
        write_entry<Order, 2, 1>(rule, rows, blend, kv, ku, out);
        write_entry<Order, 1, 2>(rule, rows, blend, kv, ku, out);
        write_entry<Order, 0, 3>(rule, rows, blend, kv, ku, out);
      }
    }
  }
}

template <int Order>
void jets_of_order(const FaceRule& rule, const double* net, const double* blend, double* out) {
  const auto write = [&] {
    switch (rule.degree_v) {
      case 2:
        return jets_in_registers<Order, 3>;
      case 3:
        return jets_in_registers<Order, 4>;
#if defined(__AVX512F__)  // 32 registers instead of 16
      case 4:
        return jets_in_registers<Order, 5>;
      case 5:
        return jets_in_registers<Order, 6>;
      case 6:
        return jets_in_registers<Order, 7>;
#endif
      default:
        return jets_in_memory<Order>;
    }
  }();
  write(rule, net, blend, out);
}

inline void jets(const FaceRule& rule, const double* net, const double* blend, int order,
                 double* out) {
  if (order <= 1) {
    jets_of_order<1>(rule, net, blend, out);
  } else if (order == 2) {
    jets_of_order<2>(rule, net, blend, out);
  } else {
    jets_of_order<3>(rule, net, blend, out);
  }
}

inline void curvature(const FaceRule& rule, const double* net, const double* blend, double* mean,
                      double* gauss) {
  Rows<2> rows;
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    contract_u<2>(rule, ku, net, rows);
    for (int kv = 0; kv < rule.nodes; ++kv) {
      const Forms x = forms(contract_v<2>(rule, rows, blend, kv, ku));
      const Lanes r = reciprocal_sqrt(x.determinant);
      const Lanes q = r * r;
      const int node = kv * rule.nodes + ku;
      store(mean + node, (0.5 * mixed_trace(x)) * (r * q));
      store(gauss + node, (x.l * x.n - x.m * x.m) * (q * q));
    }
  }
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
