#pragma once

#include "model/batch_memory.hpp"
#include "model/batch_tables.hpp"

/// The two rows of a transition that one side of its joint gives, for a batch of sides, and their
/// pullback (docs/mathematics.md, section 6).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

template <class Real, class Number>
Real strip_width(const WidthTable& table, const Number* parameters) {
  using Io = Pack<Real>;
  return Io::numbers(table.offset) +
         Io::numbers(table.factor) * Io::read(parameters, table.parameter, 0);
}

template <class Real, class Number>
void strip_width_pullback(const WidthTable& table, int count, const Real& width_bar,
                          Number* parameters_bar) {
  using Io = Pack<Real>;
  Io::add(parameters_bar, table.parameter, 0, count, Io::numbers(table.factor) * width_bar);
}

template <class Real, class Number>
Real kept_length(const SideBatch& batch, const Number* parameters) {
  return Pack<Real>::read(parameters, batch.cut_lo, 1) -
         Pack<Real>::read(parameters, batch.cut_lo, 0);
}

template <class Real, class Number>
void read_side(const SideBatch& batch, const Number* parameters, const Number* nets,
               TransitionSide<Real>& side) {
  using Io = Pack<Real>;
  for (int k = 0; k <= batch.degree; ++k) {
    side.edge[k] = Io::read_point(nets, batch.edge + k * Io::lanes, 0);
    side.second[k] = Io::read_point(nets, batch.second + k * Io::lanes, 0);
  }
  const Real reach = Io::numbers(batch.across) * strip_width<Real>(batch.width, parameters);
  side.stretch = reach / kept_length<Real>(batch, parameters);
  side.fullness = Io::read(parameters, batch.fullness, 0);
  side.lean[0] = Io::read(parameters, batch.lean, 0);
  side.lean[1] = Io::read(parameters, batch.lean, 1);
}

/// The free edge beyond an uncut side, as a derivative over the discarded strip of the other patch.
template <class Real, class Number>
void read_free_edge(const SideBatch& batch, const Number* parameters, const Number* nets,
                    SideMemory<Real>& memory) {
  using Io = Pack<Real>;
  memory.neighbour_width = strip_width<Real>(batch.other_width, parameters);
  const Real reach = Io::numbers(batch.other_across) * memory.neighbour_width;
  for (int end = 0; end < 2; ++end) {
    const int* at = batch.free_edge + 2 * end * Io::lanes;
    memory.free_edge[end] = Io::read_point(nets, at + Io::lanes, 0) - Io::read_point(nets, at, 0);
    memory.target[end] = reach * memory.free_edge[end];
  }
}

template <class Real, class Number>
[[gnu::flatten]] void build_sides(const SideBatch& batch, const Number* parameters, Number* nets,
                                  unsigned char* storage) {
  using Io = Pack<Real>;
  auto& memory = memory_at<SideMemory<Real>, Real>(storage, batch.memory);
  const TransitionSide<Real>& side = memory.side;
  read_side(batch, parameters, nets, memory.side);
  Vec3<Real> raised[max_net_degree + 2], low[max_net_degree + 1], handle[max_net_degree + 2];
  const Vec3<Real>* edge = side.edge;
  if (batch.kind == SideKind::plain) {
    transition_handle(batch.degree, side, batch.leaning, handle);
  } else if (batch.kind == SideKind::raised) {
    transition_handle(batch.degree, side, batch.leaning, low);
    elevate_once(batch.degree, side.edge, raised);
    elevate_once(batch.degree, low, handle);
    edge = raised;
  } else {
    read_free_edge(batch, parameters, nets, memory);
    uncut_handle(batch.degree, side, memory.target, memory.neighbour_width, raised, handle,
                 memory.uncut);
    edge = raised;
  }
  if (batch.raise > 1) {
    elevate_times(batch.degree + 1, batch.raise - 1, raised);
    elevate_times(batch.degree + 1, batch.raise - 1, handle);
  }
  for (int k = 0; k <= batch.degree + batch.raise; ++k) {
    Io::write_point(nets, batch.edge_row, transition_row_step * k, edge[k]);
    Io::write_point(nets, batch.handle_row, transition_row_step * k, handle[k]);
  }
}

template <class Real, class Number>
void free_edge_pullback(const SideBatch& batch, const SideMemory<Real>& memory,
                        const Vec3<Real>* target_bar, const Real& neighbour_width_bar,
                        Number* nets_bar, Number* parameters_bar) {
  using Io = Pack<Real>;
  const Real across = Io::numbers(batch.other_across), reach = across * memory.neighbour_width;
  Real reach_bar{};
  for (int end = 0; end < 2; ++end) {
    const int* at = batch.free_edge + 2 * end * Io::lanes;
    reach_bar += dot(target_bar[end], memory.free_edge[end]);
    const Vec3<Real> bar = reach * target_bar[end];
    Io::add_point(nets_bar, at + Io::lanes, 0, batch.count, bar);
    Io::add_point(nets_bar, at, 0, batch.count, -bar);
  }
  strip_width_pullback(batch.other_width, batch.count, neighbour_width_bar + across * reach_bar,
                       parameters_bar);
}

/// Adds the adjoints of what read_side read.
template <class Real, class Number>
void read_side_pullback(const SideBatch& batch, const Number* parameters,
                        const TransitionSide<Real>& side, const TransitionSide<Real>& bar,
                        Number* nets_bar, Number* parameters_bar) {
  using Io = Pack<Real>;
  for (int k = 0; k <= batch.degree; ++k) {
    Io::add_point(nets_bar, batch.edge + k * Io::lanes, 0, batch.count, bar.edge[k]);
    Io::add_point(nets_bar, batch.second + k * Io::lanes, 0, batch.count, bar.second[k]);
  }
  const Real per_length = bar.stretch / kept_length<Real>(batch, parameters);
  const Real length_bar = -(per_length * side.stretch);
  Io::add(parameters_bar, batch.cut_lo, 1, batch.count, length_bar);
  Io::add(parameters_bar, batch.cut_lo, 0, batch.count, -length_bar);
  strip_width_pullback(batch.width, batch.count, per_length * Io::numbers(batch.across),
                       parameters_bar);
  Io::add(parameters_bar, batch.fullness, 0, batch.count, bar.fullness);
  if (!batch.leaning) return;
  Io::add(parameters_bar, batch.lean, 0, batch.count, bar.lean[0]);
  Io::add(parameters_bar, batch.lean, 1, batch.count, bar.lean[1]);
}

template <class Real, class Number>
[[gnu::flatten]] void sides_pullback(const SideBatch& batch, const Number* parameters,
                                     unsigned char* storage, Number* nets_bar,
                                     Number* parameters_bar) {
  using Io = Pack<Real>;
  const auto& memory = memory_at<SideMemory<Real>, Real>(storage, batch.memory);
  const TransitionSide<Real>& side = memory.side;
  Vec3<Real> edge_bar[max_net_degree + 2], handle_bar[max_net_degree + 2];
  for (int k = 0; k <= batch.degree + batch.raise; ++k) {
    edge_bar[k] = Io::read_point(nets_bar, batch.edge_row, transition_row_step * k);
    handle_bar[k] = Io::read_point(nets_bar, batch.handle_row, transition_row_step * k);
  }
  if (batch.raise > 1) {
    elevate_times_pullback(batch.degree + 1, batch.raise - 1, edge_bar);
    elevate_times_pullback(batch.degree + 1, batch.raise - 1, handle_bar);
  }
  TransitionSide<Real> bar;
  clear(batch.degree, bar);
  if (batch.kind == SideKind::plain) {
    for (int k = 0; k <= batch.degree; ++k) bar.edge[k] = edge_bar[k];
    transition_handle_pullback(batch.degree, side, batch.leaning, handle_bar, bar);
  } else if (batch.kind == SideKind::raised) {
    Vec3<Real> low_bar[max_net_degree + 1] = {};
    elevate_once_pullback(batch.degree, edge_bar, bar.edge);
    elevate_once_pullback(batch.degree, handle_bar, low_bar);
    transition_handle_pullback(batch.degree, side, batch.leaning, low_bar, bar);
  } else {
    Vec3<Real> target_bar[2] = {};
    Real neighbour_width_bar{};
    uncut_handle_pullback(batch.degree, side, memory.target, memory.neighbour_width, memory.uncut,
                          edge_bar, handle_bar, bar, target_bar, neighbour_width_bar);
    free_edge_pullback(batch, memory, target_bar, neighbour_width_bar, nets_bar, parameters_bar);
  }
  read_side_pullback(batch, parameters, side, bar, nets_bar, parameters_bar);
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
