#pragma once

#include "model/kernel_lanes.hpp"
#include "model/kernels.hpp"

/// How strongly points of a scan pull at a face, several points at once. See kernels_impl.cpp.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// The weight of Geman and McClure, of a squared distance in units of the reach.
BODYLINE_INLINE Lanes geman_mcclure(Lanes square) {
  const Lanes root = 1.0 / (1.0 + square);
  return root * root;
}

/// Symmetric 3 x 3 matrices: xx, xy, xz, yy, yz, zz.
struct Symmetric {
  Lanes entry[6];
};

BODYLINE_INLINE Symmetric outer_square(const Vector& a) {
  return {{a.x * a.x, a.x * a.y, a.x * a.z, a.y * a.y, a.y * a.z, a.z * a.z}};
}

/// The points of one group that lie on rims of the body, and at ends of rims.
struct RimMasks {
  Mask rim, end;
};

BODYLINE_INLINE RimMasks rim_masks(const PullRule& rule, Lanes u, Lanes v) {
  const Lanes zero{}, one = broadcast(1.0);
  const Mask sides[4] = {u <= zero, u >= one, v <= zero, v >= one};
  RimMasks masks{Mask{}, (sides[0] | sides[1]) & (sides[2] | sides[3])};
  for (int k = 0; k < 4; ++k)
    if (rule.rims[k]) masks.rim |= sides[k];
  return masks;
}

inline PullSums pulls(const FootPointArrays& a, const PullRule& rule, const PullArrays& out,
                      double* distance) {
  const Lanes zero{}, one = broadcast(1.0);
  const double normal_scale = 1.0 / (rule.normal_reach * rule.normal_reach);
  const double rim_scale = 1.0 / (rule.rim_reach * rule.rim_reach);
  const double sign = rule.inward ? -1.0 : 1.0;
  const bool rims = rule.rims[0] || rule.rims[1] || rule.rims[2] || rule.rims[3];
  Lanes constant{}, total{}, index;
  for (int k = 0; k < lanes; ++k) index[k] = k;
  for (int k = 0; k < a.count; k += lanes) {
    const Vector point{load(a.x + k), load(a.y + k), load(a.z + k)};
    const Vector foot{load(a.foot[0] + k), load(a.foot[1] + k), load(a.foot[2] + k)};
    const Vector n{load(a.normal[0] + k), load(a.normal[1] + k), load(a.normal[2] + k)};
    const Vector offset = point - foot;
    const Lanes square = dot(offset, offset), off = dot(offset, n);
    Lanes cosine = one;
    if (rule.scan_normal[0]) {
      const double* const* const s = rule.scan_normal;
      cosine = sign * dot(n, Vector{load(s[0] + k), load(s[1] + k), load(s[2] + k)});
      cosine = cosine > zero ? cosine : zero;
    }
    Symmetric pull = outer_square(n);
    Lanes measure = square, rim_weight = one;
    if (rims) {
      const RimMasks masks = rim_masks(rule, load(a.u + k), load(a.v + k));
      const Vector along = offset - off * n;
      const Lanes beyond = dot(along, along);
      const Mask out_of_rim = masks.rim & (beyond > zero);
      measure = masks.rim ? off * off : measure;
      rim_weight = out_of_rim ? geman_mcclure(rim_scale * beyond) : one;
      const Mask turned = out_of_rim & (cosine < rule.least_rim_cosine);
      rim_weight = (turned | (masks.rim & masks.end)) ? zero : rim_weight;
      const Lanes scale = out_of_rim ? 1.0 / (out_of_rim ? beyond : one) : zero;
      const Symmetric outward = outer_square(along);
      for (int e = 0; e < 6; ++e) pull.entry[e] += scale * outward.entry[e];
    }
    Lanes weight = geman_mcclure(normal_scale * measure) * (cosine * cosine) * rim_weight;
    weight = index + double(k) < double(a.count) ? weight : zero;
    Lanes w[6];
    for (int e = 0; e < 6; ++e) {
      w[e] = weight * pull.entry[e];
      store(out.weight[e] + k, w[e]);
    }
    const Vector pulled{w[0] * point.x + w[1] * point.y + w[2] * point.z,
                        w[1] * point.x + w[3] * point.y + w[4] * point.z,
                        w[2] * point.x + w[4] * point.y + w[5] * point.z};
    store(out.weighted_target[0] + k, pulled.x);
    store(out.weighted_target[1] + k, pulled.y);
    store(out.weighted_target[2] + k, pulled.z);
    constant += dot(point, pulled);
    total += w[0] + w[3] + w[5];
    store(distance + k, square * reciprocal_sqrt(square > 1e-200 ? square : broadcast(1e-200)));
  }
  return {sum(constant), sum(total)};
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
