#include "strokes/fit_stroke.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace bodyline::strokes {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr int degree = 3;
constexpr int most_rounds = 12, parameter_rounds = 2;
constexpr double least_span = 1e-3;  // of the parameter
// Weight of the curve's third differences: decides only what the points leave open.
constexpr double stiffness = 1e-9;

// All four cubic B-splines that do not vanish at t, the first of them belonging to control point
// `first`. Knots are clamped at breaks 0 and 1.
struct Basis {
  int first = 0;
  std::array<double, degree + 1> value{};
};

double knot(const std::vector<double>& breaks, int index) {
  return breaks[std::clamp(index - degree, 0, static_cast<int>(breaks.size()) - 1)];
}

Basis basis_at(const std::vector<double>& breaks, double t) {
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
  Basis basis;
  basis.first = static_cast<int>(after - breaks.begin()) - 1;
  const int span = basis.first + degree;
  basis.value[0] = 1.0;
  for (int d = 1; d <= degree; ++d) {
    double saved = 0.0;
    for (int r = 0; r < d; ++r) {
      const double right = knot(breaks, span + r + 1) - t,
                   left = t - knot(breaks, span + 1 - d + r);
      const double share = basis.value[r] / (right + left);
      basis.value[r] = saved + right * share;
      saved = left * share;
    }
    basis.value[d] = saved;
  }
  return basis;
}

// The Bezier points of a piece between breaks: blossoms at its ends.
model::SplineCurve bezier_pieces(const std::vector<double>& breaks, const MatrixXd& control) {
  model::SplineCurve curve{degree, breaks, {}};
  curve.points.resize(curve.pieces() * degree + 1);
  for (int piece = 0; piece < curve.pieces(); ++piece) {
    for (int k = 0; k <= degree; ++k) {
      std::array<Vector3d, degree + 1> row;
      for (int i = 0; i <= degree; ++i) row[i] = control.row(piece + i).transpose();
      for (int level = 1; level <= degree; ++level) {
        const double t = breaks[level <= k ? piece + 1 : piece];
        for (int i = 0; i + level <= degree; ++i) {
          const double low = knot(breaks, piece + i + level),
                       high = knot(breaks, piece + i + degree + 1);
          const double share = (t - low) / (high - low);
          row[i] = (1.0 - share) * row[i] + share * row[i + 1];
        }
      }
      curve.piece(piece)[k] = row[0];
    }
  }
  return curve;
}

model::SplineCurve least_squares(const Points& points, const std::vector<double>& parameters,
                                 const std::vector<double>& breaks) {
  const int count = static_cast<int>(breaks.size()) - 1 + degree;
  MatrixXd normal = MatrixXd::Zero(count, count), right = MatrixXd::Zero(count, 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Basis basis = basis_at(breaks, parameters[k]);
    for (int i = 0; i <= degree; ++i) {
      right.row(basis.first + i) += basis.value[i] * points[k].transpose();
      for (int j = 0; j <= degree; ++j)
        normal(basis.first + i, basis.first + j) += basis.value[i] * basis.value[j];
    }
  }
  const double weight = stiffness * normal.trace();
  constexpr std::array<double, 4> difference{-1.0, 3.0, -3.0, 1.0};
  for (int k = 0; k + 3 < count; ++k)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) normal(k + i, k + j) += weight * difference[i] * difference[j];
  // The ends are given.
  MatrixXd control(count, 3);
  control.row(0) = points.front().transpose();
  control.row(count - 1) = points.back().transpose();
  const int inner = count - 2;
  right.middleRows(1, inner) -= normal.block(1, 0, inner, 1) * control.row(0) +
                                normal.block(1, count - 1, inner, 1) * control.row(count - 1);
  control.middleRows(1, inner) =
      normal.block(1, 1, inner, inner).ldlt().solve(right.middleRows(1, inner));
  model::SplineCurve curve = bezier_pieces(breaks, control);
  curve.points.front() = points.front();
  curve.points.back() = points.back();
  return curve;
}

// One step of Newton's method from each parameter towards the nearest point of the curve.
void improve(const model::SplineCurve& curve, const Points& points,
             std::vector<double>& parameters) {
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    const model::CurveJet jet = model::curve_jet(curve, parameters[k]);
    const Vector3d away = jet.point - points[k];
    const double slope = jet.first.squaredNorm() + std::max(0.0, away.dot(jet.second));
    if (!(slope > 0.0)) continue;
    const double next = parameters[k] - away.dot(jet.first) / slope;
    const double low = parameters[k - 1], high = parameters[k + 1];
    if (next > low && next < high) parameters[k] = next;
  }
}

std::vector<double> deviations(const model::SplineCurve& curve, const Points& points,
                               const std::vector<double>& parameters) {
  std::vector<double> result;
  for (std::size_t k = 0; k < points.size(); ++k)
    result.push_back((model::curve_point(curve, parameters[k]) - points[k]).norm());
  return result;
}

// Halves the spans in which a point deviates too much; false when none can be halved.
bool halve(const std::vector<double>& parameters, const std::vector<double>& deviation,
           double tolerance, std::vector<double>& breaks) {
  std::vector<double> finer{0.0};
  for (std::size_t span = 0; span + 1 < breaks.size(); ++span) {
    int held = 0;
    double worst = 0.0;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      if (parameters[k] < breaks[span] || parameters[k] > breaks[span + 1]) continue;
      ++held;
      worst = std::max(worst, deviation[k]);
    }
    if (worst > tolerance && held >= 2 && breaks[span + 1] - breaks[span] > 2.0 * least_span)
      finer.push_back(0.5 * (breaks[span] + breaks[span + 1]));
    finer.push_back(breaks[span + 1]);
  }
  if (finer.size() == breaks.size()) return false;
  breaks = std::move(finer);
  return true;
}

}  // namespace

StrokeFit fit_stroke(const Points& points, double tolerance_mm) {
  // Two points leave more open than third differences decide.
  if (points.size() == 2)
    return {model::raised_curve(model::polyline_curve({0.0, 1.0}, points), degree), 0.0};
  const std::vector<double> chords = chord_parameters(points);
  std::vector<double> breaks{0.0, 1.0};
  StrokeFit fit;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<double> parameters = chords;
    for (int k = 0; k <= parameter_rounds; ++k) {
      if (k > 0) improve(fit.curve, points, parameters);
      fit.curve = least_squares(points, parameters, breaks);
    }
    const std::vector<double> deviation = deviations(fit.curve, points, parameters);
    fit.deviation_mm = *std::max_element(deviation.begin(), deviation.end());
    if (fit.deviation_mm <= tolerance_mm || !halve(parameters, deviation, tolerance_mm, breaks))
      break;
  }
  return fit;
}

}  // namespace bodyline::strokes
