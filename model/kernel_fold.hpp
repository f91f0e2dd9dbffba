#pragma once

#include "model/kernel_integral.hpp"

/// Fold barrier: the mean over the nodes of max(0, (cosine - c) / (1 + cosine))^3, where c is the
/// cosine between the normal at a node and the face's mean normal, the direction of its vector
/// area.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// Normals shorter than the square root of this count as no direction at all: their cosine is 0.
constexpr double least_determinant = 1e-200;

struct UnitNormal {
  Vector direction;
  Lanes reciprocal_length;
};

BODYLINE_INLINE UnitNormal unit_normal(const Jet& jet) {
  const Vector normal = cross(jet.u, jet.v);
  const Lanes r = reciprocal_sqrt(dot(normal, normal) + least_determinant);
  return {r * normal, r};
}

/// A direction common to all lanes and the reciprocal of the length it had.
struct Direction {
  double x[3];
  double reciprocal_length;
};

/// Integral of the normal over the face.
BODYLINE_INLINE Direction mean_normal(const FaceRule& rule, const double* net,
                                      const double* blend) {
  Rows<1> rows;
  Vector total{};
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    contract_u<1>(rule, ku, net, rows);
    Vector strip{};
    for (int kv = 0; kv < rule.nodes; ++kv) {
      const Jet jet = contract_v<1>(rule, rows, blend, kv, ku);
      accumulate(strip, broadcast(rule.weights_v[kv]), cross(jet.u, jet.v));
    }
    accumulate(total, load(rule.weights_u + ku), strip);
  }
  const double x = sum(total.x), y = sum(total.y), z = sum(total.z);
  const double r = 1.0 / __builtin_sqrt(x * x + y * y + z * z + least_determinant);
  return {{r * x, r * y, r * z}, r};
}

/// The part of a node's cosine below the allowed one, 0 to 1.
BODYLINE_INLINE Lanes excess(const FoldOptions& options, Lanes cosine) {
  const Lanes missing = options.cosine - cosine;
  return (1.0 / (1.0 + options.cosine)) * keep_where(missing > 0.0, missing);
}

/// Sums over the nodes: the penalties, and their derivative by the mean normal.
struct FoldSums {
  double value;
  double direction_bar[3];
};

BODYLINE_INLINE FoldSums fold_sums(const FaceRule& rule, const double* net, const double* blend,
                                   const FoldOptions& options, const Direction& mean) {
  const Vector direction = broadcast_vector(mean.x);
  const double slope = -3.0 / (1.0 + options.cosine);
  Rows<1> rows;
  Lanes value{};
  Vector direction_bar{};
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    contract_u<1>(rule, ku, net, rows);
    for (int kv = 0; kv < rule.nodes; ++kv) {
      const UnitNormal normal = unit_normal(contract_v<1>(rule, rows, blend, kv, ku));
      const Lanes part = excess(options, dot(normal.direction, direction));
      value += part * part * part;
      accumulate(direction_bar, slope * (part * part), normal.direction);
    }
  }
  return {sum(value), {sum(direction_bar.x), sum(direction_bar.y), sum(direction_bar.z)}};
}

inline double fold(const FaceRule& rule, const double* net, const double* blend,
                   const FoldOptions& options) {
  const Direction mean = mean_normal(rule, net, blend);
  return fold_sums(rule, net, blend, options, mean).value / (rule.nodes * rule.nodes);
}

/// Derivative of the penalties by the vector area, from that by its direction.
BODYLINE_INLINE Direction vector_area_bar(const Direction& mean, const FoldSums& sums_,
                                          double seed) {
  const double* m = mean.x;
  const double* d = sums_.direction_bar;
  const double along = m[0] * d[0] + m[1] * d[1] + m[2] * d[2];
  const double scale = seed * mean.reciprocal_length;
  return {
      {scale * (d[0] - along * m[0]), scale * (d[1] - along * m[1]), scale * (d[2] - along * m[2])},
      0.0};
}

inline double fold_pullback(const FaceRule& rule, const double* net, const double* blend,
                            const FoldOptions& options, double seed, double* net_bar,
                            double* blend_bar) {
  const Direction mean = mean_normal(rule, net, blend);
  const FoldSums total = fold_sums(rule, net, blend, options, mean);
  if (total.value == 0.0) return 0.0;
  const double node_seed = seed / (rule.nodes * rule.nodes);
  const Vector area_bar = broadcast_vector(vector_area_bar(mean, total, node_seed).x);
  const Vector direction = broadcast_vector(mean.x);
  const double slope = -3.0 * node_seed / (1.0 + options.cosine);
  Rows<1> rows;
  Adjoint<1> adjoint;
  for (int ku = 0; ku < rule.nodes; ku += lanes) {
    contract_u<1>(rule, ku, net, rows);
    const Lanes weight_u = load(rule.weights_u + ku);
    chunk_pullback<1>(rule, rows, blend, ku, adjoint,
                      [&](int kv, const Jet& jet, Jet& bar) BODYLINE_INLINED {
                        const UnitNormal normal = unit_normal(jet);
                        const Lanes cosine = dot(normal.direction, direction);
                        const Lanes part = excess(options, cosine);
                        const Lanes scale = slope * (part * part) * normal.reciprocal_length;
                        const Vector normal_bar = scale * (direction - cosine * normal.direction) +
                                                  (rule.weights_v[kv] * weight_u) * area_bar;
                        bar.u = cross(jet.v, normal_bar);
                        bar.v = cross(normal_bar, jet.u);
                      });
  }
  finish_pullback(rule, adjoint, net_bar, blend_bar);
  return total.value / (rule.nodes * rule.nodes);
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
