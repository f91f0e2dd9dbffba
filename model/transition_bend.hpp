#pragma once

#include "model/transition.hpp"

/// The third row of a transition with continuity 2, which is quintic across (docs/mathematics.md,
/// section 6). T(s,t) = S(s + beta t, f t) to second order, with S the kept patch as it goes on
/// beyond its edge and t measured as in D; so at t = 0
///   T_t = X = f D + beta A',   T_tt = Y = f^2 S_tt + 2 f beta D' + beta^2 A'',
/// and the Bezier rows are T0 = A, T1 = A + X / 5, T2 = A + 2 X / 5 + Y / 20. All curvature of the
/// patch is in f and beta and their first derivatives along the edge, which T has too.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// One patch's part of such a transition.
template <class Real>
struct BendSide {
  TransitionSide<Real> side;
  Vec3<Real> third[max_net_degree + 1];  ///< the row of the kept net behind `side.second`
  double across_ratio = 0.0;             ///< (degree across - 1) / degree across
};

/// f and beta of a cut side: the fullness, and what the lean asks for (transition_handle).
template <class Real>
HandleRates<Real> cut_rates(int n, const TransitionSide<Real>& side, bool leaning) {
  using std::sqrt;
  HandleRates<Real> rates{{side.fullness, side.fullness}, {}};
  if (!leaning) return rates;
  const Real reach = Real(1.0 / n) * side.fullness * side.stretch;
  const Vec3<Real> first = side.edge[1] - side.edge[0], last = side.edge[n] - side.edge[n - 1];
  const Vec3<Real> across0 = side.edge[0] - side.second[0], across1 = side.edge[n] - side.second[n];
  rates.beta[0] = side.lean[0] * reach * sqrt(dot(across0, across0) / dot(first, first));
  rates.beta[1] = -side.lean[1] * reach * sqrt(dot(across1, across1) / dot(last, last));
  return rates;
}

/// Pullback of cut_rates: adds to every adjoint in `bar`.
template <class Real>
void cut_rates_pullback(int n, const TransitionSide<Real>& side, bool leaning,
                        const HandleRates<Real>& rates_bar, TransitionSide<Real>& bar) {
  using std::sqrt;
  bar.fullness += rates_bar.f[0] + rates_bar.f[1];
  if (!leaning) return;
  const Real reach = Real(1.0 / n) * side.fullness * side.stretch;
  Real reach_bar{};
  for (int end = 0; end < 2; ++end) {
    const int at = end == 0 ? 0 : n, from = end == 0 ? 0 : n - 1;
    const double sign = end == 0 ? 1.0 : -1.0;
    const Vec3<Real> along = side.edge[from + 1] - side.edge[from];
    const Vec3<Real> across = side.edge[at] - side.second[at];
    const Real across2 = dot(across, across), along2 = dot(along, along);
    const Real ratio = sqrt(across2 / along2), beta_bar = Real(sign) * rates_bar.beta[end];
    bar.lean[end] += beta_bar * reach * ratio;
    reach_bar += beta_bar * side.lean[end] * ratio;
    const Real ratio_bar = beta_bar * side.lean[end] * reach;
    const Vec3<Real> across_bar = (ratio_bar * ratio / across2) * across;
    const Vec3<Real> along_bar = (-ratio_bar * ratio / along2) * along;
    bar.edge[at] += across_bar;
    bar.second[at] -= across_bar;
    bar.edge[from + 1] += along_bar;
    bar.edge[from] -= along_bar;
  }
  bar.fullness += Real(1.0 / n) * side.stretch * reach_bar;
  bar.stretch += Real(1.0 / n) * side.fullness * reach_bar;
}

/// The derivatives of a side that Y is made of: S_tt of degree n, D' of degree n - 1, A'' of degree
/// n - 2.
template <class Real>
struct BendParts {
  Vec3<Real> across2[max_net_degree + 1], mixed[max_net_degree + 1], along2[max_net_degree + 1];
};
template <class Real>
void bend_parts(int n, const BendSide<Real>& bend, BendParts<Real>& parts) {
  const TransitionSide<Real>& side = bend.side;
  const Real square = Real(bend.across_ratio) * side.stretch * side.stretch;
  for (int j = 0; j <= n; ++j) {
    parts.across2[j] = square * (side.edge[j] - scaled(2.0, side.second[j]) + bend.third[j]);
  }
  for (int j = 0; j < n; ++j) {
    const Vec3<Real> here = side.edge[j] - side.second[j],
                     next = side.edge[j + 1] - side.second[j + 1];
    parts.mixed[j] = (Real(double(n)) * side.stretch) * (next - here);
  }
  for (int j = 0; j + 2 <= n; ++j) {
    parts.along2[j] = scaled(double(n * (n - 1)),
                             side.edge[j] - scaled(2.0, side.edge[j + 1]) + side.edge[j + 2]);
  }
}

/// Pullback of bend_parts: adds to every adjoint in `bar`.
template <class Real>
void bend_parts_pullback(int n, const BendSide<Real>& bend, const BendParts<Real>& parts_bar,
                         BendSide<Real>& bar) {
  const TransitionSide<Real>& side = bend.side;
  const Real ratio(bend.across_ratio), square = ratio * side.stretch * side.stretch;
  for (int j = 0; j <= n; ++j) {
    const Vec3<Real> moved = square * parts_bar.across2[j];
    bar.side.edge[j] += moved;
    bar.side.second[j] -= scaled(2.0, moved);
    bar.third[j] += moved;
    const Vec3<Real> bend2 = side.edge[j] - scaled(2.0, side.second[j]) + bend.third[j];
    bar.side.stretch += Real(2.0) * ratio * side.stretch * dot(parts_bar.across2[j], bend2);
  }
  for (int j = 0; j < n; ++j) {
    const Vec3<Real> here = side.edge[j] - side.second[j],
                     next = side.edge[j + 1] - side.second[j + 1];
    bar.side.stretch += Real(double(n)) * dot(parts_bar.mixed[j], next - here);
    const Vec3<Real> moved = (Real(double(n)) * side.stretch) * parts_bar.mixed[j];
    bar.side.edge[j + 1] += moved;
    bar.side.second[j + 1] -= moved;
    bar.side.edge[j] -= moved;
    bar.side.second[j] += moved;
  }
  for (int j = 0; j + 2 <= n; ++j) {
    const Vec3<Real> moved = scaled(double(n * (n - 1)), parts_bar.along2[j]);
    bar.side.edge[j] += moved;
    bar.side.edge[j + 1] -= scaled(2.0, moved);
    bar.side.edge[j + 2] += moved;
  }
}

/// beta D' and beta^2 A'', rows of degree n.
template <class Real>
struct LeanRows {
  Vec3<Real> mixed[max_net_degree + 1], along[max_net_degree + 1];
};
template <class Real>
void lean_rows(int n, const BendParts<Real>& parts, const Real* beta, LeanRows<Real>& rows) {
  Vec3<Real> once[max_net_degree + 1];
  multiply_linear(n - 1, beta, parts.mixed, rows.mixed);
  multiply_linear(n - 2, beta, parts.along2, once);
  multiply_linear(n - 1, beta, once, rows.along);
}

/// Pullback of lean_rows: adds to the adjoints of the parts and of beta.
template <class Real>
void lean_rows_pullback(int n, const BendParts<Real>& parts, const Real* beta,
                        const LeanRows<Real>& rows_bar, BendParts<Real>& parts_bar,
                        Real* beta_bar) {
  Vec3<Real> once[max_net_degree + 1], once_bar[max_net_degree + 1] = {};
  multiply_linear_pullback(n - 1, beta, parts.mixed, rows_bar.mixed, beta_bar, parts_bar.mixed);
  multiply_linear(n - 2, beta, parts.along2, once);
  multiply_linear_pullback(n - 1, beta, once, rows_bar.along, beta_bar, once_bar);
  multiply_linear_pullback(n - 2, beta, parts.along2, once_bar, beta_bar, parts_bar.along2);
}

/// Y of a cut side, of degree n: f is constant.
template <class Real>
void bend_row(int n, const BendParts<Real>& parts, const HandleRates<Real>& rates,
              Vec3<Real>* row) {
  LeanRows<Real> lean;
  lean_rows(n, parts, rates.beta, lean);
  const Real f = rates.f[0], f2 = f * f, twice_f = Real(2.0) * f;
  for (int j = 0; j <= n; ++j)
    row[j] = f2 * parts.across2[j] + twice_f * lean.mixed[j] + lean.along[j];
}

/// Pullback of bend_row: adds to the adjoints of the parts and of the rates.
template <class Real>
void bend_row_pullback(int n, const BendParts<Real>& parts, const HandleRates<Real>& rates,
                       const Vec3<Real>* row_bar, BendParts<Real>& parts_bar,
                       HandleRates<Real>& rates_bar) {
  LeanRows<Real> lean, lean_bar;
  lean_rows(n, parts, rates.beta, lean);
  const Real f = rates.f[0], f2 = f * f, twice_f = Real(2.0) * f;
  for (int j = 0; j <= n; ++j) {
    parts_bar.across2[j] += f2 * row_bar[j];
    lean_bar.mixed[j] = twice_f * row_bar[j];
    lean_bar.along[j] = row_bar[j];
    rates_bar.f[0] +=
        twice_f * dot(row_bar[j], parts.across2[j]) + Real(2.0) * dot(row_bar[j], lean.mixed[j]);
  }
  lean_rows_pullback(n, parts, rates.beta, lean_bar, parts_bar, rates_bar.beta);
}

/// Highest degree along the joint of an uncut side with continuity 2: its transition is of two
/// degrees more.
inline constexpr int max_uncut_bend_degree = max_net_degree - 1;

/// Y of an uncut side, of degree n + 2: f is linear.
template <class Real>
void uncut_bend_row(int n, const BendParts<Real>& parts, const HandleRates<Real>& rates,
                    Vec3<Real>* row) {
  const Real twice_f[2] = {Real(2.0) * rates.f[0], Real(2.0) * rates.f[1]};
  LeanRows<Real> lean;
  lean_rows(n, parts, rates.beta, lean);
  Vec3<Real> once[max_net_degree + 2], term[max_net_degree + 2];
  multiply_linear(n, rates.f, parts.across2, once);
  multiply_linear(n + 1, rates.f, once, row);
  multiply_linear(n, twice_f, lean.mixed, term);
  elevate_times(n + 1, 1, term);
  for (int j = 0; j <= n + 2; ++j) row[j] += term[j];
  for (int j = 0; j <= n; ++j) term[j] = lean.along[j];
  elevate_times(n, 2, term);
  for (int j = 0; j <= n + 2; ++j) row[j] += term[j];
}

/// Pullback of uncut_bend_row: adds to the adjoints of the parts and of the rates.
template <class Real>
void uncut_bend_row_pullback(int n, const BendParts<Real>& parts, const HandleRates<Real>& rates,
                             const Vec3<Real>* row_bar, BendParts<Real>& parts_bar,
                             HandleRates<Real>& rates_bar) {
  const Real twice_f[2] = {Real(2.0) * rates.f[0], Real(2.0) * rates.f[1]};
  LeanRows<Real> lean, lean_bar{};
  lean_rows(n, parts, rates.beta, lean);
  Vec3<Real> once[max_net_degree + 2], once_bar[max_net_degree + 2] = {};
  multiply_linear(n, rates.f, parts.across2, once);
  multiply_linear_pullback(n + 1, rates.f, once, row_bar, rates_bar.f, once_bar);
  multiply_linear_pullback(n, rates.f, parts.across2, once_bar, rates_bar.f, parts_bar.across2);
  Vec3<Real> term_bar[max_net_degree + 2];
  for (int j = 0; j <= n + 2; ++j) term_bar[j] = row_bar[j];
  elevate_times_pullback(n + 1, 1, term_bar);
  Real twice_f_bar[2] = {};
  multiply_linear_pullback(n, twice_f, lean.mixed, term_bar, twice_f_bar, lean_bar.mixed);
  for (int end = 0; end < 2; ++end) rates_bar.f[end] += Real(2.0) * twice_f_bar[end];
  for (int j = 0; j <= n + 2; ++j) term_bar[j] = row_bar[j];
  elevate_times_pullback(n, 2, term_bar);
  for (int j = 0; j <= n; ++j) lean_bar.along[j] = term_bar[j];
  lean_rows_pullback(n, parts, rates.beta, lean_bar, parts_bar, rates_bar.beta);
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
