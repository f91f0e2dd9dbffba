#include "sketch/drawn_parameters.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "sketch/curve_jet.hpp"
#include "sketch/median.hpp"

namespace bodyline::sketch {
namespace {

constexpr int looks = 3;         // at which points fit, after the first
constexpr double far_off = 3.0;  // times the median: not part of the curve, as an end drawn too far

Eigen::MatrixXd basis_of(const std::vector<double>& parameters, int degree) {
  Eigen::MatrixXd basis(Eigen::Index(parameters.size()), degree + 1);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const model::BernsteinJet jet = model::bernstein(degree, parameters[k]);
    for (int i = 0; i <= degree; ++i) basis(Eigen::Index(k), i) = jet.d[0][i];
  }
  return basis;
}

// How far a curve has run before its parameters say so, at most, as a part of its length.
double unevenness_of(const std::vector<Eigen::Vector2d>& curve) {
  constexpr int count = 64;
  std::vector<double> passed{0.0};
  for (int k = 0; k < count; ++k)
    passed.push_back(passed.back() + curve_jet<2>(curve, (k + 0.5) / count).first.norm());
  double most = 0.0;
  for (int k = 0; k <= count; ++k)
    most = std::max(most, std::abs(passed[k] / passed.back() - double(k) / count));
  return most;
}

DrawnParameters fitted(const SketchLine& line, const std::vector<double>& parameters, int degree) {
  const Eigen::MatrixXd basis = basis_of(parameters, degree);
  const Eigen::Index count = basis.rows();
  Eigen::MatrixXd drawn(count, 2);
  for (Eigen::Index k = 0; k < count; ++k) drawn.row(k) = line.points[std::size_t(k)];
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(count);
  DrawnParameters result{parameters, 0.0, 0.0};
  for (int look = 0;; ++look) {
    const Eigen::MatrixXd points =
        (weights.asDiagonal() * basis).colPivHouseholderQr().solve(weights.asDiagonal() * drawn);
    const Eigen::VectorXd distances = (basis * points - drawn).rowwise().norm();
    result.misfit = median(std::vector<double>(distances.begin(), distances.end()));
    if (look == looks) {
      std::vector<Eigen::Vector2d> curve;
      for (Eigen::Index i = 0; i <= degree; ++i) curve.emplace_back(points.row(i));
      result.unevenness = unevenness_of(curve);
      return result;
    }
    for (Eigen::Index k = 0; k < count; ++k)
      weights[k] = distances[k] <= far_off * result.misfit + 1e-9 ? 1.0 : 0.0;
  }
}

}  // namespace

DrawnParameters drawn_parameters(const SketchLine& line, int degree) {
  // Only a clear gain speaks against equal steps, which are known exactly.
  constexpr double clear = 0.5;
  DrawnParameters best;
  if (int(line.points.size()) < 4 * (degree + 1)) return best;
  for (const std::vector<double>& parameters : line.drawn) {
    DrawnParameters found = fitted(line, parameters, degree);
    if (best.parameters.empty() || found.misfit < clear * best.misfit) best = std::move(found);
  }
  return best;
}

}  // namespace bodyline::sketch
