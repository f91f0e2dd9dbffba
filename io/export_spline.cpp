#include "io/export_spline.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/gregory_blend.hpp"

namespace bodyline::io {
namespace {

// Knots halve towards the corner, down to 2^-levels, and every interval is cut into equal pieces.
// Seven levels keep the normals next to the corner within a few thousandths of a degree.
constexpr int least_levels = 7, most_levels = 14;
constexpr int most_pieces = 4;
constexpr int least_degree = 4;  // carries the blend's cubic cross derivatives along the edges

/// A clamped knot vector over [0,1] with simple knots inside.
struct Knots {
  int degree = 0;
  std::vector<double> flat;
  int count() const { return static_cast<int>(flat.size()) - degree - 1; }
};

Knots clamped(int degree, const std::vector<double>& breaks) {
  Knots knots{degree, std::vector<double>(degree, 0.0)};
  knots.flat.insert(knots.flat.end(), breaks.begin(), breaks.end());
  knots.flat.insert(knots.flat.end(), degree, 1.0);
  return knots;
}

/// All B-splines of `degree` over the flat knots at t.
Eigen::VectorXd basis(const std::vector<double>& flat, int degree, double t) {
  const int intervals = static_cast<int>(flat.size()) - 1;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(intervals);
  int k = degree;
  while (k + 1 < intervals - degree && flat[k + 1] <= t) ++k;
  b[k] = 1.0;
  for (int d = 1; d <= degree; ++d)
    for (int i = 0; i + d < intervals; ++i) {
      const double left = flat[i + d] - flat[i], right = flat[i + d + 1] - flat[i + 1];
      b[i] = (left > 0.0 ? (t - flat[i]) / left * b[i] : 0.0) +
             (right > 0.0 ? (flat[i + d + 1] - t) / right * b[i + 1] : 0.0);
    }
  return b.head(intervals - degree);
}

double greville(const Knots& knots, int i) {
  double sum = 0.0;
  for (int k = 1; k <= knots.degree; ++k) sum += knots.flat[i + k];
  return sum / knots.degree;
}

/// Control points of the polynomial of the same degree with Bezier points `bezier` over the knots:
/// its blossom at the knots.
Eigen::MatrixXd bezier_to_spline(const Knots& knots) {
  Eigen::MatrixXd matrix(knots.count(), knots.degree + 1);
  for (int i = 0; i < knots.count(); ++i) {
    // De Casteljau with one argument a step, on the unit vectors.
    Eigen::MatrixXd steps = Eigen::MatrixXd::Identity(knots.degree + 1, knots.degree + 1);
    for (int k = 1; k <= knots.degree; ++k) {
      const double t = knots.flat[i + k];
      for (int r = 0; r + k <= knots.degree; ++r)
        steps.row(r) = (1.0 - t) * steps.row(r) + t * steps.row(r + 1);
    }
    matrix.row(i) = steps.row(0);
  }
  return matrix;
}

/// The interpolation conditions in one direction: value and slope at both ends, values in between.
struct Conditions {
  std::vector<double> at;      ///< parameter
  std::vector<bool> is_slope;  ///< derivative instead of value
  Eigen::MatrixXd inverse;     ///< from conditions to control points
};

Conditions conditions(const Knots& knots) {
  const int n = knots.count();
  Conditions c;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    const bool slope = i == 1 || i == n - 2;
    c.is_slope.push_back(slope);
    c.at.push_back(slope ? (i == 1 ? 0.0 : 1.0) : greville(knots, i));
    if (!slope) {
      matrix.row(i) = basis(knots.flat, knots.degree, c.at[i]).transpose();
      continue;
    }
    const int low = i == 1 ? 0 : n - 2;
    const double factor = knots.degree / (knots.flat[low + 1 + knots.degree] - knots.flat[low + 1]);
    matrix(i, low) = -factor;
    matrix(i, low + 1) = factor;
  }
  c.inverse = matrix.partialPivLu().inverse();
  return c;
}

/// Value, slope or mixed derivative of the blend function. Next to (0,0) its two twists, -1 and 1,
/// disagree and blend_jet answers with their mean, 0.
double apply(const Conditions& cu, int i, const Conditions& cv, int j) {
  const auto g = model::blend_jet(cu.at[i], cv.at[j]);
  return g[model::jet_index(cu.is_slope[i] ? 1 : 0, cv.is_slope[j] ? 1 : 0)];
}

/// Coefficients of a spline that follows the blend function.
Eigen::MatrixXd fit_blend(const Knots& ku, const Knots& kv) {
  const Conditions cu = conditions(ku), cv = conditions(kv);
  Eigen::MatrixXd data(ku.count(), kv.count());
  for (int i = 0; i < ku.count(); ++i)
    for (int j = 0; j < kv.count(); ++j) data(i, j) = apply(cu, i, cv, j);
  Eigen::MatrixXd fit = cu.inverse * data * cv.inverse.transpose();
  // The conditions on the boundary are zeros; rounding must not move the boundary curves.
  fit.row(0).setZero();
  fit.row(ku.count() - 1).setZero();
  fit.col(0).setZero();
  fit.col(kv.count() - 1).setZero();
  return fit;
}

/// Largest error of the fit, sampled evenly in every knot interval.
double fit_error(const Eigen::MatrixXd& fit, const Knots& ku, const Knots& kv,
                 const std::vector<double>& breaks) {
  std::vector<double> at;
  constexpr int per_interval = 7;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    for (int s = 0; s < per_interval; ++s)
      at.push_back(breaks[k] + (breaks[k + 1] - breaks[k]) * s / per_interval);
  double largest = 0.0;
  for (double u : at) {
    const Eigen::RowVectorXd row = basis(ku.flat, ku.degree, u).transpose() * fit;
    for (double v : at)
      largest = std::max(largest,
                         std::abs(row * basis(kv.flat, kv.degree, v) - model::blend_jet(u, v)[0]));
  }
  return largest;
}

/// 0, 2^-levels, ..., 1/4, 1/2, 1 with every interval in `pieces`: finer towards the corner where
/// the blend is not smooth.
std::vector<double> graded_breaks(int levels, int pieces) {
  std::vector<double> breaks{0.0};
  for (int k = levels; k >= 0; --k) {
    const double from = breaks.back(), to = std::ldexp(1.0, -k);
    for (int s = 1; s <= pieces; ++s)
      breaks.push_back(s == pieces ? to : from + (to - from) * s / pieces);
  }
  return breaks;
}

SplineSurface bezier_surface(const model::Surface& surface) {
  return {surface.degree_u,     surface.degree_v, {0.0, 1.0}, surface.degree_u + 1,
          surface.degree_v + 1, surface.net,      0.0};
}

SplineSurface with_fit(const model::Surface& surface, const Knots& ku, const Knots& kv,
                       const Eigen::MatrixXd& fit) {
  const Eigen::MatrixXd from_u = bezier_to_spline(ku), from_v = bezier_to_spline(kv);
  SplineSurface spline{ku.degree, kv.degree, {}, ku.count(), kv.count(), {}, 0.0};
  spline.net.assign(ku.count() * kv.count(), Eigen::Vector3d::Zero());
  for (int c = 0; c < 3; ++c) {
    Eigen::MatrixXd net(surface.degree_u + 1, surface.degree_v + 1);
    for (int i = 0; i <= surface.degree_u; ++i)
      for (int j = 0; j <= surface.degree_v; ++j) net(i, j) = surface.point(i, j)[c];
    const Eigen::MatrixXd moved = from_u * net * from_v.transpose() + (*surface.blend)[c] * fit;
    for (int i = 0; i < ku.count(); ++i)
      for (int j = 0; j < kv.count(); ++j) spline.net[i * kv.count() + j][c] = moved(i, j);
  }
  return spline;
}

}  // namespace

SplineSurface spline_surface(const model::Surface& surface, double tolerance_mm) {
  if (!surface.blend || surface.blend->isZero(0.0)) return bezier_surface(surface);
  if (surface.degree_u < least_degree || surface.degree_v < least_degree)
    throw std::runtime_error("a face with a Gregory term needs degree 4 or more: " + surface.name);
  for (int levels = least_levels, pieces = 1; levels <= most_levels;
       pieces == most_pieces ? ++levels : ++pieces) {
    const auto breaks = graded_breaks(levels, pieces);
    const Knots ku = clamped(surface.degree_u, breaks), kv = clamped(surface.degree_v, breaks);
    const Eigen::MatrixXd fit = fit_blend(ku, kv);
    const double deviation = surface.blend->norm() * fit_error(fit, ku, kv, breaks);
    if (deviation > tolerance_mm) continue;
    SplineSurface spline = with_fit(surface, ku, kv, fit);
    spline.breaks = breaks;
    spline.deviation_mm = deviation;
    return spline;
  }
  throw std::runtime_error("the Gregory term of " + surface.name +
                           " is too large to be approximated by a B-spline");
}

}  // namespace bodyline::io
