#include "strokes/patch_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;

constexpr int polish_steps = 3;

Vector2d clamped(const Vector2d& st) { return st.cwiseMax(0.0).cwiseMin(1.0); }

Vector2d triangle_parameters(const Polygon& c, const Vector2d& place) {
  const double whole = cross(c[1] - c[0], c[2] - c[0]);
  const double of_1 = cross(place - c[0], c[2] - c[0]) / whole;
  const double of_2 = cross(c[1] - c[0], place - c[0]) / whole;
  const double base = 1.0 - of_2;
  return clamped({base > 0.0 ? of_1 / base : 0.0, of_2});
}

// The root of C + B s + A s^2 in or nearest to [0, 1]. Of a convex quadrilateral it is the one
// that B alone would give when the sides are parallel.
double bilinear_root(double a, double b, double c) {
  const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
  const double q = -0.5 * (b + std::copysign(root, b));
  const auto outside = [](double s) { return std::max({0.0, -s, s - 1.0}); };
  const double first = q != 0.0 ? c / q : 0.0;
  const double second = a != 0.0 ? q / a : first;
  return outside(first) <= outside(second) ? first : second;
}

Vector2d quadrilateral_parameters(const Polygon& c, const Vector2d& place) {
  const Vector2d a = c[0] - place, b = c[1] - c[0], d = c[3] - c[0], g = c[0] - c[1] + c[2] - c[3];
  Vector2d st;
  st[0] = bilinear_root(cross(b, g), cross(a, g) + cross(b, d), cross(a, d));
  const Vector2d up = d + st[0] * g;
  st[1] = -(a + st[0] * b).dot(up) / up.squaredNorm();
  for (int k = 0; k < polish_steps; ++k) {
    Eigen::Matrix2d slope;
    slope << b + st[1] * g, d + st[0] * g;
    const Vector2d step = slope.partialPivLu().solve(to_domain(c, st) - place);
    if (!step.allFinite() || step.norm() > 1.0) break;
    st -= step;
  }
  return clamped(st);
}

}  // namespace

Vector2d to_domain(const Polygon& c, const Vector2d& st) {
  const double s = st[0], t = st[1];
  const Vector2d low = (1.0 - s) * c[0] + s * c[1];
  const Vector2d high = c.size() == 3 ? c[2] : Vector2d((1.0 - s) * c[3] + s * c[2]);
  return (1.0 - t) * low + t * high;
}

Vector2d from_domain(const Polygon& corners, const Vector2d& place) {
  return corners.size() == 3 ? triangle_parameters(corners, place)
                             : quadrilateral_parameters(corners, place);
}

}  // namespace bodyline::strokes
