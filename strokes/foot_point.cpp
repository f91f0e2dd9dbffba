#include "strokes/foot_point.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "strokes/segment_distance.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int fewest_cells = 4, most_cells = 12;
constexpr int most_steps = 60, most_halvings = 20;
constexpr double smallest_step = 1e-13;  // of a parameter
constexpr double smallest_gain = 1e-15;  // of the squared distance

int facet_cells(const PatchShape& shape) {
  std::size_t breaks = 0;
  for (const auto& curve : shape.sides().curves) breaks = std::max(breaks, curve.breaks.size());
  return std::clamp(static_cast<int>(breaks) / 2, fewest_cells, most_cells);
}

// What a parabola through three neighbours keeps from its chords, doubled to be safe.
double estimated_sag(const Facets& facets) {
  double largest = 0.0;
  for (int i = 0; i <= facets.cells; ++i) {
    for (int j = 1; j < facets.cells; ++j) {
      const Vector3d along_t =
          facets.point(i, j - 1) - 2.0 * facets.point(i, j) + facets.point(i, j + 1);
      const Vector3d along_s =
          facets.point(j - 1, i) - 2.0 * facets.point(j, i) + facets.point(j + 1, i);
      largest = std::max({largest, along_t.norm(), along_s.norm()});
    }
  }
  return 2.0 * 2.0 * largest / 8.0;
}

/// The nearest point of a triangle, as parts of its two edges from its first corner.
Vector2d nearest_in_triangle(const Vector3d& p0, const Vector3d& ps, const Vector3d& pt,
                             const Vector3d& q) {
  const Vector3d along_s = ps - p0, along_t = pt - p0, normal = along_t.cross(along_s);
  const double squared = normal.squaredNorm();
  if (squared > 0.0) {
    // Eq. 2 and 3: k_s / |S| and k_r / |R|.
    const double a = normal.dot(along_t.cross(q - p0)) / squared;
    const double b = normal.dot((q - p0).cross(along_s)) / squared;
    if (a >= 0.0 && b >= 0.0 && a + b <= 1.0) return {a, b};
  }
  const double on_s = nearest_on_segment(p0, ps, q), on_t = nearest_on_segment(p0, pt, q),
               between = nearest_on_segment(ps, pt, q);
  const Vector2d candidates[3] = {{on_s, 0.0}, {0.0, on_t}, {1.0 - between, between}};
  return *std::min_element(candidates, candidates + 3, [&](const Vector2d& x, const Vector2d& y) {
    const auto away = [&](const Vector2d& w) {
      return (p0 + w[0] * along_s + w[1] * along_t - q).squaredNorm();
    };
    return away(x) < away(y);
  });
}

Vector2d clamped(const Vector2d& st) { return st.cwiseMax(0.0).cwiseMin(1.0); }

// Newton's step for half the squared distance, or Gauss and Newton's where that does not lead
// downhill; parameters at a bound that would leave stay.
Vector2d newton_step(const PatchJet& jet, const Vector2d& gradient, const Vector2d& st,
                     const Vector3d& away) {
  Eigen::Matrix2d gauss, full;
  gauss << jet.s.squaredNorm(), jet.s.dot(jet.t), jet.s.dot(jet.t), jet.t.squaredNorm();
  full << jet.ss.dot(away), jet.st.dot(away), jet.st.dot(away), jet.tt.dot(away);
  full += gauss;
  gauss += 1e-12 * gauss.trace() * Eigen::Matrix2d::Identity();
  Vector2d free(1.0, 1.0);
  for (int k : {0, 1})
    if ((st[k] <= 0.0 && gradient[k] > 0.0) || (st[k] >= 1.0 && gradient[k] < 0.0)) free[k] = 0.0;
  if (free.sum() == 0.0) return Vector2d::Zero();
  if (free.sum() == 1.0) {
    const int k = free[0] == 1.0 ? 0 : 1;
    const double slope = full(k, k) > 0.0 ? full(k, k) : gauss(k, k);
    Vector2d step = Vector2d::Zero();
    if (slope > 0.0) step[k] = -gradient[k] / slope;
    return step;
  }
  const bool convex = full(0, 0) > 0.0 && full.determinant() > 1e-12 * gauss.determinant() &&
                      full.determinant() > 0.0;
  const Vector2d step = -(convex ? full : gauss).ldlt().solve(gradient);
  return step.allFinite() ? step : Vector2d::Zero();
}

}  // namespace

Facets make_facets(const PatchShape& shape) {
  Facets facets;
  facets.cells = facet_cells(shape);
  for (int i = 0; i <= facets.cells; ++i)
    for (int j = 0; j <= facets.cells; ++j)
      facets.points.push_back(shape.point(Vector2d(i, j) / facets.cells));
  facets.sag = estimated_sag(facets);
  return facets;
}

PatchFoot nearest_facet(const Facets& facets, const Vector3d& point) {
  PatchFoot best;
  best.distance = std::numeric_limits<double>::infinity();
  const auto look = [&](int i, int j, int step) {  // a triangle from (i, j), forwards or backwards
    const Vector3d &p0 = facets.point(i, j), &ps = facets.point(i + step, j),
                   &pt = facets.point(i, j + step);
    const Vector2d w = nearest_in_triangle(p0, ps, pt, point);
    const Vector3d foot = p0 + w[0] * (ps - p0) + w[1] * (pt - p0);
    const double distance = (foot - point).norm();
    if (distance < best.distance)
      best = {(Vector2d(i, j) + step * w) / facets.cells, foot, distance};
  };
  for (int i = 0; i < facets.cells; ++i) {
    for (int j = 0; j < facets.cells; ++j) {
      look(i, j, 1);
      look(i + 1, j + 1, -1);
    }
  }
  return best;
}

PatchFoot refined_foot(const PatchShape& shape, Vector2d st, const Vector3d& point) {
  PatchJet jet = shape.jet(st);
  double distance = (jet.point - point).norm();
  for (int k = 0; k < most_steps; ++k) {
    const Vector3d away = jet.point - point;
    const Vector2d gradient(jet.s.dot(away), jet.t.dot(away));
    const Vector2d step = newton_step(jet, gradient, st, away);
    if (-gradient.dot(step) <= smallest_gain * distance * distance) break;
    double part = 1.0;
    bool closer = false;
    for (int halving = 0; halving < most_halvings && !closer; ++halving, part *= 0.5) {
      const Vector2d next = clamped(st + part * step);
      if ((next - st).cwiseAbs().maxCoeff() <= smallest_step) break;
      const PatchJet there = shape.jet(next);
      if (!((there.point - point).norm() < distance)) continue;
      closer = true;
      st = next;
      jet = there;
      distance = (jet.point - point).norm();
    }
    if (!closer) break;
  }
  return {st, jet.point, distance};
}

}  // namespace bodyline::strokes
