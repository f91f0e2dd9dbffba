#pragma once

#include "model/kernel_transpose.hpp"

/// Integrals over a face of a density that depends on the jet at each node, and their pullbacks.
/// All scratch memory is on the stack, at most 80 KB.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// Adjoints of what lies between the net and the jets.
template <int Order>
struct Adjoint {
  Vector blend{};
  NetLanes net;
  Rows<Order> rows;
  JetBlock jets;
};

/// Adds the adjoint of the jet at nodes (ku .., kv) to that of the Gregory coefficient.
template <int Order>
BODYLINE_INLINE void blend_pullback(const FaceRule& rule, int kv, int ku, Jet& jet_bar,
                                    Vector& blend_bar) {
  for_each_derivative<Order>(
      jet_bar, [&](int q, Vector& d) { accumulate(blend_bar, blend_table(rule, q, kv, ku), d); });
}

/// Calls node(kv, jet, jet_bar), which sets jet_bar, for all nodes kv of the chunk at ku, and takes
/// the adjoints back as far as the sums over the lanes.
template <int Order, class Node>
BODYLINE_INLINE void chunk_pullback(const FaceRule& rule, const Rows<Order>& rows,
                                    const double* blend, int ku, Adjoint<Order>& adjoint,
                                    Node node) {
  for (int first = 0; first < rule.nodes; first += block) {
    for (int k = 0; k < block; ++k) {
      Jet& jet_bar = adjoint.jets.jets[k];
      node(first + k, contract_v<Order>(rule, rows, blend, first + k, ku), jet_bar);
      if (rule.blend != nullptr) {
        blend_pullback<Order>(rule, first + k, ku, jet_bar, adjoint.blend);
      }
    }
    contract_v_transposed<Order>(rule, first, adjoint.jets, adjoint.rows);
  }
  contract_u_transposed<Order>(rule, ku, adjoint.rows, adjoint.net);
}

/// The last step: adds to the caller's adjoints.
template <int Order>
BODYLINE_INLINE void finish_pullback(const FaceRule& rule, const Adjoint<Order>& adjoint,
                                     double* net_bar, double* blend_bar) {
  add_sums(adjoint.net, 3 * (rule.degree_u + 1) * (rule.degree_v + 1), net_bar);
  if (rule.blend == nullptr) return;
  blend_bar[0] += sum(adjoint.blend.x);
  blend_bar[1] += sum(adjoint.blend.y);
  blend_bar[2] += sum(adjoint.blend.z);
}

/// Integral of Density::value over the face.
template <class Density>
double integral(const FaceRule& rule, const double* net, const double* blend) {
  Rows<Density::order> rows;
  Lanes total{};
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    contract_u<Density::order>(rule, ku, net, rows);
    Lanes strip{};
    for (int kv = 0; kv < rule.nodes; ++kv) {
      const Jet jet = contract_v<Density::order>(rule, rows, blend, kv, ku);
      strip += rule.weights_v[kv] * Density::value(jet);
    }
    total += load(rule.weights_u + ku) * strip;
  }
  return sum(total);
}

/// The same, and seed times its derivative added to net_bar and blend_bar.
template <class Density>
double integral_pullback(const FaceRule& rule, const double* net, const double* blend, double seed,
                         double* net_bar, double* blend_bar) {
  constexpr int order = Density::order;
  Rows<order> rows;
  Adjoint<order> adjoint;
  Lanes total{};
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    contract_u<order>(rule, ku, net, rows);
    const Lanes weight_u = load(rule.weights_u + ku);
    chunk_pullback<order>(rule, rows, blend, ku, adjoint,
                          [&](int kv, const Jet& jet, Jet& bar) BODYLINE_INLINED {
                            const Lanes weight = rule.weights_v[kv] * weight_u;
                            total += weight * Density::pullback(jet, seed * weight, bar);
                          });
  }
  finish_pullback(rule, adjoint, net_bar, blend_bar);
  return sum(total);
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
