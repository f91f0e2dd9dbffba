#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <span>

#include "model/bernstein.hpp"

namespace bodyline::sketch {

/// A point of a Bezier curve and its first two derivatives.
template <int Dimensions>
struct CurveJet {
  Eigen::Vector<double, Dimensions> point, first, second;
};

/// The jet of the curve with these control points, three or more, at t, which may lie outside
/// [0,1], by de Casteljau's scheme.
template <int Dimensions>
CurveJet<Dimensions> curve_jet(std::span<const Eigen::Vector<double, Dimensions>> points,
                               double t) {
  std::array<Eigen::Vector<double, Dimensions>, model::max_degree + 1> row;
  std::copy(points.begin(), points.end(), row.begin());
  const std::size_t degree = points.size() - 1;
  for (std::size_t left = degree; left > 2; --left)
    for (std::size_t i = 0; i < left; ++i) row[i] += t * (row[i + 1] - row[i]);
  const Eigen::Vector<double, Dimensions> a = row[0] + t * (row[1] - row[0]),
                                          b = row[1] + t * (row[2] - row[1]);
  return {a + t * (b - a), double(degree) * (b - a),
          double(degree * (degree - 1)) * (row[2] - 2.0 * row[1] + row[0])};
}

/// The length of a curve in space from t = 0 to 1, by a midpoint rule: within some thousandths.
inline double curve_length(std::span<const Eigen::Vector3d> points) {
  constexpr int count = 32;
  double length = 0.0;
  for (int k = 0; k < count; ++k) length += curve_jet<3>(points, (k + 0.5) / count).first.norm();
  return length / count;
}

}  // namespace bodyline::sketch
