#pragma once

#include "model/batch_corners.hpp"
#include "model/batch_sides.hpp"
#include "model/transition_bend.hpp"

/// Joints with continuity 2: the three rows of a quintic transition that one side gives, and the
/// corner patches beside such transitions (docs/mathematics.md, sections 6 and 7). One step at a
/// time, after all batches of several lanes.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// Degree across of a transition with continuity 2.
inline constexpr int bend_degree = 5;

template <class Real>
struct BendSideMemory {
  SideMemory<Real> rows;
  BendSide<Real> bend;  ///< of which `side` is that of `rows`
  BendParts<Real> parts;
};

template <class Real, class Number>
void read_bend_side(const SideBatch& batch, const Number* parameters, const Number* nets,
                    BendSideMemory<Real>& memory) {
  using Io = Pack<Real>;
  read_side(batch, parameters, nets, memory.rows.side);
  memory.bend.side = memory.rows.side;
  for (int k = 0; k <= batch.degree; ++k)
    memory.bend.third[k] = Io::read_point(nets, batch.third + k * Io::lanes, 0);
  memory.bend.across_ratio = (batch.across[0] - 1.0) / batch.across[0];
  bend_parts(batch.degree, memory.bend, memory.parts);
}

/// f and beta of an uncut side, once its handle has been built.
template <class Real>
HandleRates<Real> uncut_rates(const SideMemory<Real>& memory) {
  const Real floor = Real(least_uncut_reach) * memory.side.fullness * memory.neighbour_width;
  HandleRates<Real> rates;
  for (int end = 0; end < 2; ++end) {
    rates.f[end] = lifted(memory.uncut.solution[end].p, floor);
    rates.beta[end] = memory.uncut.solution[end].q;
  }
  return rates;
}

/// The rows A + X / 3 and Y of a side, and A itself, each in the lowest degree that all have:
/// returns that degree.
template <class Real, class Number>
int bend_rows(const SideBatch& batch, const Number* parameters, const Number* nets,
              BendSideMemory<Real>& memory, Vec3<Real>* edge, Vec3<Real>* handle,
              Vec3<Real>* bend) {
  const int n = batch.degree;
  SideMemory<Real>& rows = memory.rows;
  if (batch.kind != SideKind::uncut) {
    for (int k = 0; k <= n; ++k) edge[k] = rows.side.edge[k];
    transition_handle(n, rows.side, batch.leaning, handle);
    bend_row(n, memory.parts, cut_rates(n, rows.side, batch.leaning), bend);
    return n;
  }
  read_free_edge(batch, parameters, nets, rows);
  uncut_handle(n, rows.side, rows.target, rows.neighbour_width, edge, handle, rows.uncut);
  uncut_bend_row(n, memory.parts, uncut_rates(rows), bend);
  elevate_times(n + 1, 1, edge);
  elevate_times(n + 1, 1, handle);
  return n + 2;
}

/// T0, T1 and T2 of one side.
template <class Real, class Number>
void build_bend_side(const SideBatch& batch, const Number* parameters, Number* nets,
                     unsigned char* storage) {
  using Io = Pack<Real>;
  auto& memory = memory_at<BendSideMemory<Real>, Real>(storage, batch.memory);
  read_bend_side(batch, parameters, nets, memory);
  constexpr int points = max_net_degree + 2;
  Vec3<Real> edge[points], handle[points], bend[points];
  const int degree = bend_rows(batch, parameters, nets, memory, edge, handle, bend);
  const int last = batch.degree + batch.raise;
  elevate_times(degree, last - degree, edge);
  elevate_times(degree, last - degree, handle);
  elevate_times(degree, last - degree, bend);
  for (int k = 0; k <= last; ++k) {
    const Vec3<Real> x = scaled(3.0, handle[k] - edge[k]);  // T_t, as in bend_rows
    Io::write_point(nets, batch.edge_row, bend_row_step * k, edge[k]);
    Io::write_point(nets, batch.handle_row, bend_row_step * k, edge[k] + scaled(0.2, x));
    Io::write_point(nets, batch.bend_row, bend_row_step * k,
                    edge[k] + scaled(0.4, x) + scaled(0.05, bend[k]));
  }
}

/// Pullback of bend_rows and of what it read: adds to all adjoints.
template <class Real, class Number>
void bend_rows_pullback(const SideBatch& batch, const Number* parameters,
                        const BendSideMemory<Real>& memory, Vec3<Real>* edge_bar,
                        Vec3<Real>* handle_bar, const Vec3<Real>* bend_bar, Number* nets_bar,
                        Number* parameters_bar) {
  using Io = Pack<Real>;
  const int n = batch.degree;
  const SideMemory<Real>& rows = memory.rows;
  BendSide<Real> bar;
  clear(n, bar.side);
  for (int k = 0; k <= n; ++k) bar.third[k] = Vec3<Real>{};
  BendParts<Real> parts_bar{};
  HandleRates<Real> rates_bar;
  if (batch.kind != SideKind::uncut) {
    const HandleRates<Real> rates = cut_rates(n, rows.side, batch.leaning);
    bend_row_pullback(n, memory.parts, rates, bend_bar, parts_bar, rates_bar);
    cut_rates_pullback(n, rows.side, batch.leaning, rates_bar, bar.side);
    transition_handle_pullback(n, rows.side, batch.leaning, handle_bar, bar.side);
    for (int k = 0; k <= n; ++k) bar.side.edge[k] += edge_bar[k];
  } else {
    uncut_bend_row_pullback(n, memory.parts, uncut_rates(rows), bend_bar, parts_bar, rates_bar);
    elevate_times_pullback(n + 1, 1, edge_bar);
    elevate_times_pullback(n + 1, 1, handle_bar);
    Vec3<Real> target_bar[2] = {};
    Real width_bar{};
    uncut_handle_pullback(n, rows.side, rows.target, rows.neighbour_width, rows.uncut, edge_bar,
                          handle_bar, bar.side, target_bar, width_bar, rates_bar);
    free_edge_pullback(batch, rows, target_bar, width_bar, nets_bar, parameters_bar);
  }
  bend_parts_pullback(n, memory.bend, parts_bar, bar);
  for (int k = 0; k <= n; ++k)
    Io::add_point(nets_bar, batch.third + k * Io::lanes, 0, batch.count, bar.third[k]);
  read_side_pullback(batch, parameters, rows.side, bar.side, nets_bar, parameters_bar);
}

template <class Real, class Number>
void bend_side_pullback(const SideBatch& batch, const Number* parameters, unsigned char* storage,
                        Number* nets_bar, Number* parameters_bar) {
  using Io = Pack<Real>;
  const auto& memory = memory_at<BendSideMemory<Real>, Real>(storage, batch.memory);
  constexpr int points = max_net_degree + 2;
  Vec3<Real> edge_bar[points], handle_bar[points], bend_bar[points];
  const int last = batch.degree + batch.raise;
  for (int k = 0; k <= last; ++k) {
    const Vec3<Real> t0 = Io::read_point(nets_bar, batch.edge_row, bend_row_step * k);
    const Vec3<Real> t1 = Io::read_point(nets_bar, batch.handle_row, bend_row_step * k);
    const Vec3<Real> t2 = Io::read_point(nets_bar, batch.bend_row, bend_row_step * k);
    const Vec3<Real> x_bar = scaled(0.2, t1) + scaled(0.4, t2);
    bend_bar[k] = scaled(0.05, t2);
    handle_bar[k] = scaled(3.0, x_bar);
    edge_bar[k] = t0 + t1 + t2 - handle_bar[k];
  }
  const int degree = batch.kind == SideKind::uncut ? batch.degree + 2 : batch.degree;
  elevate_times_pullback(degree, last - degree, edge_bar);
  elevate_times_pullback(degree, last - degree, handle_bar);
  elevate_times_pullback(degree, last - degree, bend_bar);
  bend_rows_pullback(batch, parameters, memory, edge_bar, handle_bar, bend_bar, nets_bar,
                     parameters_bar);
}

/// The ends of transitions around a corner; cubic ones are raised.
template <class Real, class Number>
void read_bend_corner(const CornerBatch& batch, const Number* nets,
                      TransitionEnd<Real, bend_degree>* edges) {
  using Io = Pack<Real>;
  for (int e = 0; e < 4; ++e) {
    if (e == top && batch.all_apex) continue;
    const Real degree = Io::numbers(batch.degree + e);
    TransitionEnd<Real, bend_degree> read;
    for (int t = 0; t < batch.points[e]; ++t) {
      const int row = 6 * e + t;
      read.curve[t] = Io::read_point(nets, batch.end + row, 0);
      read.inward[t] = degree * (read.curve[t] - Io::read_point(nets, batch.next + row, 0));
    }
    if (batch.points[e] == bend_degree + 1) {
      edges[e] = read;
    } else {
      elevate<3, 2>(read.curve, edges[e].curve);
      elevate<3, 2>(read.inward, edges[e].inward);
    }
  }
}

template <class Real, class Number>
void build_bend_corner(const CornerBatch& batch, Number* nets, unsigned char* storage) {
  using Io = Pack<Real>;
  auto& memory = memory_at<CornerMemory<Real, bend_degree>, Real>(storage, batch.memory);
  read_bend_corner(batch, nets, memory.edges);
  Vec3<Real> net[corner_points(bend_degree)], blend;
  corner_net(corner_mix<Real>(batch), memory.edges, memory.trace, net, &blend);
  Io::write_net(nets, batch.net, corner_points(bend_degree), net);
  Io::write_point(nets, batch.blend, 0, Io::numbers(batch.seam) * blend);
}

template <class Real, class Number>
void bend_corner_pullback(const CornerBatch& batch, unsigned char* storage, Number* nets_bar) {
  using Io = Pack<Real>;
  const auto& memory = memory_at<CornerMemory<Real, bend_degree>, Real>(storage, batch.memory);
  Vec3<Real> net_bar[corner_points(bend_degree)];
  Io::read_net(nets_bar, batch.net, corner_points(bend_degree), net_bar);
  const Vec3<Real> blend_bar = Io::numbers(batch.seam) * Io::read_point(nets_bar, batch.blend, 0);
  TransitionEnd<Real, bend_degree> edges_bar[4] = {};
  const CornerMix<Real> mix = corner_mix<Real>(batch);
  corner_net_pullback(mix, memory.edges, memory.trace, net_bar, blend_bar, edges_bar);
  for (int e = 0; e < 4; ++e) {
    if (e == top && mix.all) continue;
    const Real degree = Io::numbers(batch.degree + e);
    TransitionEnd<Real, bend_degree> bar = edges_bar[e];
    if (batch.points[e] != bend_degree + 1) {
      bar = {};
      elevate_pullback<3, 2>(edges_bar[e].curve, bar.curve);
      elevate_pullback<3, 2>(edges_bar[e].inward, bar.inward);
    }
    for (int t = 0; t < batch.points[e]; ++t) {
      const int row = 6 * e + t;
      const Vec3<Real> inward_bar = degree * bar.inward[t];
      Io::add_point(nets_bar, batch.end + row, 0, batch.count, bar.curve[t] + inward_bar);
      Io::add_point(nets_bar, batch.next + row, 0, batch.count, -inward_bar);
    }
  }
}

/// After build_batches up to the body.
template <class Real, class Number>
void build_bends(const BatchTables& tables, const Number* parameters, Number* nets,
                 unsigned char* storage) {
  for (int k = 0; k < tables.bend_side_count; ++k)
    build_bend_side<Real>(tables.bend_sides[k], parameters, nets, storage);
  for (int k = 0; k < tables.bend_corner_count; ++k)
    build_bend_corner<Real>(tables.bend_corners[k], nets, storage);
}

/// Before batches_pullback from the body: adds to the adjoints of the parameters and of the nets.
template <class Real, class Number>
void bends_pullback(const BatchTables& tables, const Number* parameters, unsigned char* storage,
                    Number* nets_bar, Number* parameters_bar) {
  for (int k = tables.bend_corner_count; k-- > 0;)
    bend_corner_pullback<Real>(tables.bend_corners[k], storage, nets_bar);
  for (int k = tables.bend_side_count; k-- > 0;)
    bend_side_pullback<Real>(tables.bend_sides[k], parameters, storage, nets_bar, parameters_bar);
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
