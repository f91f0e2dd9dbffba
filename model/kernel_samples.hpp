#pragma once

#include "model/kernel_forms.hpp"

/// Kernels that write a value for every node.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

BODYLINE_INLINE void store_entry(double* out, int plane, const Vector& d) {
  store(out, d.x);
  store(out + plane, d.y);
  store(out + 2 * plane, d.z);
}

template <int Order>
void jets_of_order(const FaceRule& rule, const double* net, const double* blend, double* out) {
  const int plane = rule.nodes * rule.nodes;
  Rows<Order> rows;
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    contract_u<Order>(rule, ku, net, rows);
    for (int kv = 0; kv < rule.nodes; ++kv) {
      Jet jet = contract_v<Order, true>(rule, rows, blend, kv, ku);
      double* node = out + kv * rule.nodes + ku;
      store_entry(node, plane, jet.point);
      for_each_derivative<Order>(
          jet, [&](int q, Vector& d) { store_entry(node + 3 * q * plane, plane, d); });
    }
  }
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
