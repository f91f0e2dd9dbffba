#include "strokes/inner_spline.hpp"

#include <algorithm>
#include <array>

#include "model/bezier_row.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

constexpr int degree = 3;

/// Bernstein polynomials of degree 3 over a piece of a length, with two derivatives.
std::array<std::array<double, 3>, degree + 1> weights(double x, double length) {
  constexpr double unit[degree + 1][degree + 1] = {
      {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  std::array<std::array<double, 3>, degree + 1> result;
  for (int k = 0; k <= degree; ++k) {
    result[k] = model::bezier_jet(unit[k], degree, x);
    result[k][1] /= length;
    result[k][2] /= length * length;
  }
  return result;
}

}  // namespace

InnerSpline::InnerSpline(int cells, const std::function<Node(double s, double t)>& node)
    : cells_(cells) {
  const int count = degree * cells + 1;
  const double third = 1.0 / (degree * cells);
  net_.assign(static_cast<std::size_t>(count) * count, Vector3d::Zero());
  for (int i = 1; i < cells; ++i) {
    for (int j = 1; j < cells; ++j) {
      const Node at = node(static_cast<double>(i) / cells, static_cast<double>(j) / cells);
      for (const int a : {-1, 0, 1})
        for (const int b : {-1, 0, 1})
          net_[(degree * i + a) * count + degree * j + b] =
              at.value + a * third * at.s + b * third * at.t + a * b * third * third * at.st;
    }
  }
}

Eigen::Matrix<double, 6, 3> InnerSpline::jet(double s, double t) const {
  const int i = std::clamp(static_cast<int>(s * cells_), 0, cells_ - 1),
            j = std::clamp(static_cast<int>(t * cells_), 0, cells_ - 1);
  const auto in_s = weights(s * cells_ - i, 1.0 / cells_),
             in_t = weights(t * cells_ - j, 1.0 / cells_);
  const int count = degree * cells_ + 1;
  Eigen::Matrix<double, 6, 3> jet = Eigen::Matrix<double, 6, 3>::Zero();
  for (int a = 0; a <= degree; ++a) {
    for (int b = 0; b <= degree; ++b) {
      const Vector3d& point = net_[(degree * i + a) * count + degree * j + b];
      constexpr int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
      for (int k = 0; k < 6; ++k)
        jet.row(k) += in_s[a][orders[k][0]] * in_t[b][orders[k][1]] * point.transpose();
    }
  }
  return jet;
}

std::vector<double> InnerSpline::breaks() const {
  std::vector<double> breaks;
  for (int k = 0; k <= cells_; ++k) breaks.push_back(static_cast<double>(k) / cells_);
  return breaks;
}

std::vector<Vector3d> InnerSpline::points(int degree_s, const std::vector<double>& breaks_s,
                                          int degree_t, const std::vector<double>& breaks_t) const {
  const auto refined = [this](std::vector<Vector3d> row, int to_degree,
                              const std::vector<double>& to_breaks) {
    return model::refined_curve(model::raised_curve({degree, breaks(), std::move(row)}, to_degree),
                                to_breaks)
        .points;
  };
  const std::size_t own = static_cast<std::size_t>(degree) * cells_ + 1;
  std::vector<std::vector<Vector3d>> rows;
  for (std::size_t i = 0; i < own; ++i) {
    const auto begin = net_.begin() + static_cast<std::ptrdiff_t>(i * own);
    rows.push_back(refined({begin, begin + static_cast<std::ptrdiff_t>(own)}, degree_t, breaks_t));
  }
  const std::size_t count_s = (breaks_s.size() - 1) * degree_s + 1, count_t = rows.front().size();
  std::vector<Vector3d> result(count_s * count_t);
  for (std::size_t j = 0; j < count_t; ++j) {
    std::vector<Vector3d> column;
    for (const auto& row : rows) column.push_back(row[j]);
    column = refined(std::move(column), degree_s, breaks_s);
    for (std::size_t i = 0; i < count_s; ++i) result[i * count_t + j] = column[i];
  }
  return result;
}

}  // namespace bodyline::strokes
