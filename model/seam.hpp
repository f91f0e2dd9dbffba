#pragma once

#include <cmath>

#include "model/elevation.hpp"
#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

/// Making two patches G1 along a seam by moving the second rows of both kept nets
/// (docs/mathematics.md, section 8).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// Rows of the two kept nets at a seam of degree n, index 0 at its free end (away from the pillar
/// foot). `edge` is the seam, `across_a` = edge - second row of a, `across_b` = second row of b -
/// edge.
template <class Real>
struct SeamRows {
  Vec3<Real> edge[max_net_degree + 1];
  Vec3<Real> across_a[max_net_degree + 1];
  Vec3<Real> across_b[max_net_degree + 1];
};

/// What the correction computed on its way, for the pullback.
template <class Real>
struct SeamTrace {
  Real inverse_norm_a, inverse_norm_b, inverse_norm;  // of t x A0, t x B0, and their unit sum
  Vec3<Real> normal_a, normal_b,
      normal;         // unit normals of both handles' planes, and the mean plane's
  Vec3<Real> a0, b0;  // handles projected onto the mean plane
  Real rho, lean0, lean1, inverse_weight;
  Vec3<Real> residual[max_net_degree + 1];
};

/// Corrects across_a and across_b so that B(s) = rho A(s) + beta(s) c'(s) exactly: the handles at
/// index 0 are projected onto their mean plane, which fixes rho and beta(0); beta(1) and the moves
/// of the other rows are the least-squares solution with the smallest moves. Needs sqrt of Real.
template <class Real>
void correct_seam(int n, SeamRows<Real>& rows, SeamTrace<Real>& trace) {
  using std::sqrt;
  const Vec3<Real> t = rows.edge[1] - rows.edge[0];
  const Vec3<Real> plane_a = cross(t, rows.across_a[0]), plane_b = cross(t, rows.across_b[0]);
  trace.inverse_norm_a = Real(1.0) / sqrt(dot(plane_a, plane_a));
  trace.inverse_norm_b = Real(1.0) / sqrt(dot(plane_b, plane_b));
  trace.normal_a = trace.inverse_norm_a * plane_a;
  trace.normal_b = trace.inverse_norm_b * plane_b;
  const Vec3<Real> sum = trace.normal_a + trace.normal_b;
  trace.inverse_norm = Real(1.0) / sqrt(dot(sum, sum));
  trace.normal = trace.inverse_norm * sum;
  trace.a0 = rows.across_a[0] - dot(rows.across_a[0], trace.normal) * trace.normal;
  trace.b0 = rows.across_b[0] - dot(rows.across_b[0], trace.normal) * trace.normal;
  trace.rho = dot(cross(t, trace.b0), trace.normal) / dot(cross(t, trace.a0), trace.normal);
  trace.lean0 = dot(trace.b0 - trace.rho * trace.a0, t) / dot(t, t);
  Real overlap{}, weight{};
  for (int j = 1; j <= n; ++j) {
    Vec3<Real> residual = rows.across_b[j] - trace.rho * rows.across_a[j];
    if (j < n)
      residual -= Real(fractions.rest[n][j]) * (trace.lean0 * (rows.edge[j + 1] - rows.edge[j]));
    const Vec3<Real> step = scaled(fractions.value[n][j], rows.edge[j] - rows.edge[j - 1]);
    overlap += dot(step, residual);
    weight += dot(step, step);
    trace.residual[j] = residual;
  }
  trace.inverse_weight = Real(1.0) / weight;
  trace.lean1 = overlap * trace.inverse_weight;
  const Real share = Real(1.0) / (Real(1.0) + trace.rho * trace.rho);
  rows.across_a[0] = trace.a0;
  rows.across_b[0] = trace.b0;
  for (int j = 1; j <= n; ++j) {
    trace.residual[j] -=
        Real(fractions.value[n][j]) * (trace.lean1 * (rows.edge[j] - rows.edge[j - 1]));
    rows.across_a[j] += (trace.rho * share) * trace.residual[j];
    rows.across_b[j] -= share * trace.residual[j];
  }
}

/// Pullback of correct_seam. `before` are the rows before the correction; `bar` holds the adjoints
/// of the corrected rows and is replaced by those of the rows before (edge's are added to).
template <class Real>
void correct_seam_pullback(int n, const SeamRows<Real>& before, const SeamTrace<Real>& trace,
                           SeamRows<Real>& bar) {
  const Real& rho = trace.rho;
  const Real share = Real(1.0) / (Real(1.0) + rho * rho);
  const Real d_share = Real(-2.0) * rho * share * share;
  Vec3<Real> residual_bar[max_net_degree + 1];
  Real rho_bar{}, lean0_bar{}, lean1_bar{};
  for (int j = 1; j <= n; ++j) {
    residual_bar[j] = share * (rho * bar.across_a[j] - bar.across_b[j]);
    const Real on_a = dot(bar.across_a[j], trace.residual[j]),
               on_b = dot(bar.across_b[j], trace.residual[j]);
    rho_bar += (share + rho * d_share) * on_a - d_share * on_b;
    lean1_bar -=
        Real(fractions.value[n][j]) * dot(residual_bar[j], before.edge[j] - before.edge[j - 1]);
    const Vec3<Real> step_bar = Real(-fractions.value[n][j]) * (trace.lean1 * residual_bar[j]);
    bar.edge[j] += step_bar;
    bar.edge[j - 1] -= step_bar;
  }
  // lean1 = overlap / weight; the residual before its share of lean1 was taken off is residual +
  // lean1 step.
  const Real overlap_bar = lean1_bar * trace.inverse_weight;
  const Real weight_bar = -trace.lean1 * overlap_bar;
  for (int j = 1; j <= n; ++j) {
    const double along = fractions.value[n][j];
    const Vec3<Real> step = scaled(along, before.edge[j] - before.edge[j - 1]);
    const Vec3<Real> first = trace.residual[j] + trace.lean1 * step;
    const Vec3<Real> step_bar = overlap_bar * first + (weight_bar + weight_bar) * step;
    bar.edge[j] += scaled(along, step_bar);
    bar.edge[j - 1] -= scaled(along, step_bar);
    residual_bar[j] += overlap_bar * step;
    bar.across_a[j] -= rho * residual_bar[j];
    bar.across_b[j] += residual_bar[j];
    rho_bar -= dot(residual_bar[j], before.across_a[j]);
    if (j < n) {
      const Vec3<Real> delta = before.edge[j + 1] - before.edge[j];
      lean0_bar -= Real(1.0 - along) * dot(residual_bar[j], delta);
      const Vec3<Real> delta_bar = Real(along - 1.0) * (trace.lean0 * residual_bar[j]);
      bar.edge[j + 1] += delta_bar;
      bar.edge[j] -= delta_bar;
    }
  }
  const Vec3<Real> t = before.edge[1] - before.edge[0];
  Vec3<Real> t_bar{}, normal_bar{}, a0_bar = bar.across_a[0], b0_bar = bar.across_b[0];
  // lean0 = (b0 - rho a0) . t / (t . t)
  const Real scaled_lean0 = lean0_bar / dot(t, t);
  const Vec3<Real> difference = trace.b0 - rho * trace.a0;
  b0_bar += scaled_lean0 * t;
  a0_bar -= (rho * scaled_lean0) * t;
  rho_bar -= scaled_lean0 * dot(trace.a0, t);
  t_bar += scaled_lean0 * difference - (Real(2.0) * trace.lean0 * scaled_lean0) * t;
  // rho = (t x b0) . normal / (t x a0) . normal
  const Vec3<Real> turn_a = cross(t, trace.a0), turn_b = cross(t, trace.b0);
  const Real numerator_bar = rho_bar / dot(turn_a, trace.normal);
  const Real denominator_bar = -rho * numerator_bar;
  normal_bar += numerator_bar * turn_b + denominator_bar * turn_a;
  cross_pullback(t, trace.b0, numerator_bar * trace.normal, t_bar, b0_bar);
  cross_pullback(t, trace.a0, denominator_bar * trace.normal, t_bar, a0_bar);
  // a0 = A - (A . normal) normal, likewise b0
  const Vec3<Real>&handle_a = before.across_a[0], &handle_b = before.across_b[0];
  const Real a_out = dot(a0_bar, trace.normal), b_out = dot(b0_bar, trace.normal);
  normal_bar -= dot(handle_a, trace.normal) * a0_bar + a_out * handle_a;
  normal_bar -= dot(handle_b, trace.normal) * b0_bar + b_out * handle_b;
  Vec3<Real> handle_a_bar = a0_bar - a_out * trace.normal,
             handle_b_bar = b0_bar - b_out * trace.normal;
  // three normalisations
  const auto normalise_pullback = [](const Vec3<Real>& unit, const Real& inverse_norm,
                                     const Vec3<Real>& unit_bar) {
    return inverse_norm * (unit_bar - dot(unit, unit_bar) * unit);
  };
  const Vec3<Real> sum_bar = normalise_pullback(trace.normal, trace.inverse_norm, normal_bar);
  cross_pullback(t, handle_a, normalise_pullback(trace.normal_a, trace.inverse_norm_a, sum_bar),
                 t_bar, handle_a_bar);
  cross_pullback(t, handle_b, normalise_pullback(trace.normal_b, trace.inverse_norm_b, sum_bar),
                 t_bar, handle_b_bar);
  bar.across_a[0] = handle_a_bar;
  bar.across_b[0] = handle_b_bar;
  bar.edge[1] += t_bar;
  bar.edge[0] -= t_bar;
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
