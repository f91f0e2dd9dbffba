#pragma once

#include "model/batch_memory.hpp"
#include "model/batch_tables.hpp"

/// A batch of corner patches, and their pullback (docs/mathematics.md, sections 7 and 8).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

template <class Real>
CornerMix<Real> corner_mix(const CornerBatch& batch) {
  return {batch.some_apex, batch.all_apex, Pack<Real>::numbers(batch.apex)};
}

template <class Real, class Number>
void read_corner_edges(const CornerBatch& batch, const Number* nets, TransitionEnd<Real>* edges) {
  using Io = Pack<Real>;
  for (int e = 0; e < 4; ++e) {
    if (e == top && batch.all_apex) continue;
    const Real degree = Io::numbers(batch.degree + e * Io::lanes);
    for (int t = 0; t < 4; ++t) {
      const int row = (4 * e + t) * Io::lanes;
      edges[e].curve[t] = Io::read_point(nets, batch.end + row, 0);
      edges[e].inward[t] = degree * (edges[e].curve[t] - Io::read_point(nets, batch.next + row, 0));
    }
  }
}

template <class Real, class Number>
[[gnu::flatten]] void build_corners(const CornerBatch& batch, Number* nets,
                                    unsigned char* storage) {
  using Io = Pack<Real>;
  auto& memory = memory_at<CornerMemory<Real>, Real>(storage, batch.memory);
  read_corner_edges(batch, nets, memory.edges);
  Vec3<Real> net[corner_points()], blend;
  corner_net(corner_mix<Real>(batch), memory.edges, memory.trace, net, &blend);
  Io::write_net(nets, batch.net, corner_points(), net);
  Io::write_point(nets, batch.blend, 0, Io::numbers(batch.seam) * blend);
}

template <class Real, class Number>
[[gnu::flatten]] void corners_pullback(const CornerBatch& batch, unsigned char* storage,
                                       Number* nets_bar) {
  using Io = Pack<Real>;
  const auto& memory = memory_at<CornerMemory<Real>, Real>(storage, batch.memory);
  Vec3<Real> net_bar[corner_points()];
  Io::read_net(nets_bar, batch.net, corner_points(), net_bar);
  const Vec3<Real> blend_bar = Io::numbers(batch.seam) * Io::read_point(nets_bar, batch.blend, 0);
  TransitionEnd<Real> edges_bar[4] = {};
  const CornerMix<Real> mix = corner_mix<Real>(batch);
  corner_net_pullback(mix, memory.edges, memory.trace, net_bar, blend_bar, edges_bar);
  for (int e = 0; e < 4; ++e) {
    if (e == top && mix.all) continue;
    const Real degree = Io::numbers(batch.degree + e * Io::lanes);
    for (int t = 0; t < 4; ++t) {
      const int row = (4 * e + t) * Io::lanes;
      const Vec3<Real> inward_bar = degree * edges_bar[e].inward[t];
      Io::add_point(nets_bar, batch.end + row, 0, batch.count, edges_bar[e].curve[t] + inward_bar);
      Io::add_point(nets_bar, batch.next + row, 0, batch.count, -inward_bar);
    }
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
