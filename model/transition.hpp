#pragma once

#include <cmath>

#include "model/elevation.hpp"
#include "model/isa_namespace.hpp"
#include "model/plane_solve.hpp"
#include "model/vec3.hpp"
#include "model/where.hpp"

/// The transition across a joint: cubic across, the joint's degree along (docs/mathematics.md,
/// section 6). Each side gives two rows, its kept edge and the handle row; both are functions of
/// that side alone.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// One patch's part of a transition, in the direction of the joint.
template <class Real>
struct TransitionSide {
  Vec3<Real> edge[max_net_degree + 1];    ///< kept edge
  Vec3<Real> second[max_net_degree + 1];  ///< the row of the kept net behind it
  Real stretch;  ///< across degree * (width cut away) / (width kept): D = stretch * (edge - second)
  Real fullness;
  Real lean[2];  ///< at both ends of the joint, inwards
};

/// Sets the rows of degree n and the numbers of adjoints to zero.
template <class Real>
void clear(int n, TransitionSide<Real>& bar) {
  for (int j = 0; j <= n; ++j) bar.edge[j] = bar.second[j] = Vec3<Real>{};
  bar.stretch = bar.fullness = bar.lean[0] = bar.lean[1] = Real{};
}

/// Handle row T1 of a cut side: edge + (f D + beta A0') / 3, beta linear with beta(0) |A0'| =
/// lean[0] f |D| and beta(1) |A0'| = -lean[1] f |D|. With `leaning` false the lean is taken as zero
/// and costs nothing. Needs sqrt of Real and a positive stretch and fullness.
template <class Real>
void transition_handle(int n, const TransitionSide<Real>& side, bool leaning, Vec3<Real>* handle) {
  using std::sqrt;
  const Real reach = Real(1.0 / 3.0) * side.fullness * side.stretch;
  for (int j = 0; j <= n; ++j) handle[j] = side.edge[j] + reach * (side.edge[j] - side.second[j]);
  if (!leaning) return;
  const Vec3<Real> first = side.edge[1] - side.edge[0], last = side.edge[n] - side.edge[n - 1];
  const Vec3<Real> across0 = side.edge[0] - side.second[0], across1 = side.edge[n] - side.second[n];
  const Real move0 = side.lean[0] * reach * sqrt(dot(across0, across0) / dot(first, first));
  const Real move1 = -side.lean[1] * reach * sqrt(dot(across1, across1) / dot(last, last));
  for (int k = 0; k < n; ++k) {
    const Vec3<Real> step = side.edge[k + 1] - side.edge[k];
    handle[k] += (Real(fractions.rest[n][k]) * move0) * step;
    handle[k + 1] += (Real(fractions.value[n][k + 1]) * move1) * step;
  }
}

/// Pullback of transition_handle: adds to every adjoint in `bar`.
template <class Real>
void transition_handle_pullback(int n, const TransitionSide<Real>& side, bool leaning,
                                const Vec3<Real>* handle_bar, TransitionSide<Real>& bar) {
  using std::sqrt;
  const Real reach = Real(1.0 / 3.0) * side.fullness * side.stretch;
  Real reach_bar{};
  for (int j = 0; j <= n; ++j) {
    reach_bar += dot(handle_bar[j], side.edge[j] - side.second[j]);
    bar.edge[j] += (Real(1.0) + reach) * handle_bar[j];
    bar.second[j] -= reach * handle_bar[j];
  }
  if (leaning) {
    for (int end = 0; end < 2; ++end) {
      const int at = end == 0 ? 0 : n, next = end == 0 ? 1 : n - 1;
      const double sign = end == 0 ? 1.0 : -1.0;
      // Both ends seen from outside in: along points inwards, so the move is lean * reach * ratio
      // at either end.
      const Vec3<Real> along =
          scaled(sign, end == 0 ? side.edge[1] - side.edge[0] : side.edge[n] - side.edge[n - 1]);
      const Vec3<Real> across = side.edge[at] - side.second[at];
      const Real across2 = dot(across, across), along2 = dot(along, along);
      const Real ratio = sqrt(across2 / along2);
      const Real move = Real(sign) * side.lean[end] * reach * ratio;
      Real move_bar{};
      for (int k = 0; k < n; ++k) {
        // Step k of the edge appears in handle k (end 0) or handle k + 1 (end 1), by the product
        // with beta.
        const int row = end == 0 ? k : k + 1;
        const double weight = end == 0 ? fractions.rest[n][k] : fractions.value[n][k + 1];
        move_bar += Real(weight) * dot(handle_bar[row], side.edge[k + 1] - side.edge[k]);
        const Vec3<Real> step_bar = (Real(weight) * move) * handle_bar[row];
        bar.edge[k + 1] += step_bar;
        bar.edge[k] -= step_bar;
      }
      const Real signed_bar = Real(sign) * move_bar;
      bar.lean[end] += signed_bar * reach * ratio;
      reach_bar += signed_bar * side.lean[end] * ratio;
      const Real ratio_bar = signed_bar * side.lean[end] * reach;
      const Vec3<Real> across_bar = (ratio_bar * ratio / across2) * across;
      const Vec3<Real> along_bar = (-ratio_bar * ratio / along2) * along;
      bar.edge[at] += across_bar - along_bar;
      bar.second[at] -= across_bar;
      bar.edge[next] += along_bar;
    }
  }
  bar.fullness += Real(1.0 / 3.0) * side.stretch * reach_bar;
  bar.stretch += Real(1.0 / 3.0) * side.fullness * reach_bar;
}

/// x where it is at least `floor`, else a positive number below it that fades out as x falls: twice
/// continuously differentiable, increasing, floor / (1 + y + y^2) with y = 1 - x / floor. The floor
/// must be positive.
template <class Real>
Real lifted(const Real& x, const Real& floor) {
  const Real y = Real(1.0) - x / floor;
  return where_at_least(x, floor, x, floor / (Real(1.0) + y + y * y));
}

/// Pullback of lifted: adds to the adjoints of both arguments.
template <class Real>
void lifted_pullback(const Real& x, const Real& floor, const Real& bar, Real& x_bar,
                     Real& floor_bar) {
  const Real ratio = x / floor;
  const Real y = Real(1.0) - ratio;
  const Real factor = Real(1.0) / (Real(1.0) + y + y * y);
  const Real slope = (Real(1.0) + y + y) * factor * factor;
  x_bar += where_at_least(x, floor, bar, slope * bar);
  floor_bar += where_at_least(x, floor, Real(0.0), (factor - slope * ratio) * bar);
}

/// An uncut side's handle reaches across by at least this part of what a side cut as wide as its
/// neighbour would.
inline constexpr double least_uncut_reach = 0.2;

/// What the construction of an uncut side computed on its way, for the pullback.
template <class Real>
struct UncutTrace {
  PlaneCoordinates<Real> solution[2];  ///< (f, beta) at both ends before f is lifted
};

/// Handle row of a side that is not cut back, one degree higher: edge + (f(s) D + beta(s) A0') / 3
/// with f and beta linear, such that at each end the handle follows `target[end]` (the free edge
/// beyond, times the fullness) as closely as the side's tangent plane allows. Where the free edge
/// does not lead away from this side, f would not be positive and the transition would fold: it is
/// lifted to stay positive. Here stretch is across degree / width kept, and `neighbour_width` the
/// width of the strip cut from the other patch. `raised_edge` and `handle` get n + 2 points.
template <class Real>
void uncut_handle(int n, const TransitionSide<Real>& side, const Vec3<Real>* target,
                  const Real& neighbour_width, Vec3<Real>* raised_edge, Vec3<Real>* handle,
                  UncutTrace<Real>& trace) {
  Vec3<Real> across[max_net_degree + 1], along[max_net_degree + 1];
  for (int j = 0; j <= n; ++j) across[j] = side.stretch * (side.edge[j] - side.second[j]);
  for (int j = 0; j < n; ++j) along[j] = scaled(double(n), side.edge[j + 1] - side.edge[j]);
  for (int end = 0; end < 2; ++end) {
    const Vec3<Real> aim = side.fullness * target[end];
    trace.solution[end] = plane_solve(across[end == 0 ? 0 : n], along[end == 0 ? 0 : n - 1], aim);
  }
  const Real floor = Real(least_uncut_reach) * side.fullness * neighbour_width;
  const Real f[2] = {lifted(trace.solution[0].p, floor), lifted(trace.solution[1].p, floor)};
  const Real beta[2] = {trace.solution[0].q, trace.solution[1].q};
  Vec3<Real> sum[max_net_degree + 2], lean[max_net_degree + 1];
  multiply_linear(n, f, across, sum);
  multiply_linear(n - 1, beta, along, lean);
  Vec3<Real> raised_lean[max_net_degree + 2];
  elevate_once(n, lean, raised_lean);
  elevate_once(n, side.edge, raised_edge);
  for (int j = 0; j <= n + 1; ++j)
    handle[j] = raised_edge[j] + scaled(1.0 / 3.0, sum[j] + raised_lean[j]);
}

/// f and beta as linear functions along the edge, by their ends.
template <class Real>
struct HandleRates {
  Real f[2] = {}, beta[2] = {};
};

/// Pullback of uncut_handle: adds to the adjoints of the side, of the two targets and of the
/// neighbour's width. `rates_bar` are adjoints that the rates have from elsewhere.
template <class Real>
void uncut_handle_pullback(int n, const TransitionSide<Real>& side, const Vec3<Real>* target,
                           const Real& neighbour_width, const UncutTrace<Real>& trace,
                           const Vec3<Real>* raised_edge_bar, const Vec3<Real>* handle_bar,
                           TransitionSide<Real>& bar, Vec3<Real>* target_bar,
                           Real& neighbour_width_bar, HandleRates<Real> rates_bar = {}) {
  Vec3<Real> across[max_net_degree + 1], along[max_net_degree + 1];
  for (int j = 0; j <= n; ++j) across[j] = side.stretch * (side.edge[j] - side.second[j]);
  for (int j = 0; j < n; ++j) along[j] = scaled(double(n), side.edge[j + 1] - side.edge[j]);
  Vec3<Real> sum_bar[max_net_degree + 2], edge_bar[max_net_degree + 2];
  for (int j = 0; j <= n + 1; ++j) {
    sum_bar[j] = scaled(1.0 / 3.0, handle_bar[j]);
    edge_bar[j] = handle_bar[j] + raised_edge_bar[j];
  }
  elevate_once_pullback(n, edge_bar, bar.edge);
  Vec3<Real> lean_bar[max_net_degree + 1] = {};
  elevate_once_pullback(n, sum_bar, lean_bar);
  const Real floor = Real(least_uncut_reach) * side.fullness * neighbour_width;
  const Real f[2] = {lifted(trace.solution[0].p, floor), lifted(trace.solution[1].p, floor)};
  const Real beta[2] = {trace.solution[0].q, trace.solution[1].q};
  Real *f_bar = rates_bar.f, *beta_bar = rates_bar.beta;
  Vec3<Real> across_bar[max_net_degree + 1] = {}, along_bar[max_net_degree + 1] = {};
  multiply_linear_pullback(n, f, across, sum_bar, f_bar, across_bar);
  multiply_linear_pullback(n - 1, beta, along, lean_bar, beta_bar, along_bar);
  for (int end = 0; end < 2; ++end) {
    const int at = end == 0 ? 0 : n, step = end == 0 ? 0 : n - 1;
    Vec3<Real> aim_bar{};
    PlaneCoordinates<Real> solution_bar{Real(0.0), beta_bar[end]};
    Real floor_bar{};
    lifted_pullback(trace.solution[end].p, floor, f_bar[end], solution_bar.p, floor_bar);
    bar.fullness += Real(least_uncut_reach) * neighbour_width * floor_bar;
    neighbour_width_bar += Real(least_uncut_reach) * side.fullness * floor_bar;
    plane_solve_pullback(across[at], along[step], side.fullness * target[end], trace.solution[end],
                         solution_bar, across_bar[at], along_bar[step], aim_bar);
    bar.fullness += dot(aim_bar, target[end]);
    target_bar[end] += side.fullness * aim_bar;
  }
  for (int j = 0; j <= n; ++j) {
    bar.stretch += dot(across_bar[j], side.edge[j] - side.second[j]);
    bar.edge[j] += side.stretch * across_bar[j];
    bar.second[j] -= side.stretch * across_bar[j];
  }
  for (int j = 0; j < n; ++j) {
    bar.edge[j + 1] += scaled(double(n), along_bar[j]);
    bar.edge[j] -= scaled(double(n), along_bar[j]);
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
