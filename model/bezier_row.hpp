#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "model/bernstein.hpp"

/// Rows of Bezier points of any degree up to max_degree, and of any kind: numbers or vectors.
namespace bodyline::model {

/// The part of a row of `degree` + 1 points over [a, b], as a row over [0, 1]. By blossoms: part k
/// is the blossom at b (k times) and a (degree - k times). `part` must not overlap `row`.
template <class Point>
void bezier_part(const Point* row, int degree, double a, double b, Point* part) {
  std::array<Point, max_degree + 1> work;
  for (int k = 0; k <= degree; ++k) {
    std::copy(row, row + degree + 1, work.begin());
    for (int level = 1; level <= degree; ++level) {
      const double t = level <= k ? b : a;
      for (int i = 0; i + level <= degree; ++i) work[i] = (1.0 - t) * work[i] + t * work[i + 1];
    }
    part[k] = work[0];
  }
  if (a == 0.0) part[0] = row[0];
  if (b == 1.0) part[degree] = row[degree];
}

/// The same row with `raised_degree` + 1 points. `raised` must not overlap `row`.
template <class Point>
void bezier_raised(const Point* row, int degree, int raised_degree, Point* raised) {
  std::copy(row, row + degree + 1, raised);
  for (int n = degree; n < raised_degree; ++n) {
    raised[n + 1] = raised[n];
    for (int k = n; k >= 1; --k) {
      const double share = static_cast<double>(k) / (n + 1);
      raised[k] = share * raised[k - 1] + (1.0 - share) * raised[k];
    }
  }
}

/// Value, first and second derivative of a row at t (de Casteljau).
template <class Point>
std::array<Point, 3> bezier_jet(const Point* row, int degree, double t) {
  std::array<Point, max_degree + 1> work;
  std::copy(row, row + degree + 1, work.begin());
  Point first = 0.0 * work[0], second = 0.0 * work[0];
  for (int level = 1; level <= degree; ++level) {
    const int left = degree - level;  // points that remain, less one
    if (left == 1) second = degree * (degree - 1.0) * (work[2] - 2.0 * work[1] + work[0]);
    if (left == 0) first = static_cast<double>(degree) * (work[1] - work[0]);
    for (int i = 0; i <= left; ++i) work[i] = (1.0 - t) * work[i] + t * work[i + 1];
  }
  return {work[0], first, second};
}

/// The product of a row of numbers and a row, of degree p + q.
template <class Point>
void bezier_product(const double* factor, int p, const Point* row, int q, Point* product) {
  for (int k = 0; k <= p + q; ++k) {
    Point sum = 0.0 * row[0];
    for (int i = std::max(0, k - q); i <= std::min(k, p); ++i)
      sum += binomial(p, i) * binomial(q, k - i) / binomial(p + q, k) * factor[i] * row[k - i];
    product[k] = sum;
  }
}

}  // namespace bodyline::model
