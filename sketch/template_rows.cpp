#include "sketch/template_rows.hpp"

#include <cmath>
#include <vector>

#include "sketch/curve_jet.hpp"
#include "sketch/curve_rows.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector3d;
using Points = std::span<const Vector3d>;

constexpr double vertex_error = 300.0;  // mm

// Calls work(t, direction, error) at places along a curve: by how much of its length it runs faster
// there than the template.
template <typename Work>
void for_speeds(Points points, const CurveTemplate& like, const Work& work) {
  constexpr int places = 10;
  const double shape_length = curve_length(like.shape);
  if (!(like.length > 0.0 && shape_length > 0.0)) return;
  for (int k = 0; k < places; ++k) {
    const double t = (k + 0.5) / places;
    const Vector3d velocity = curve_jet<3>(points, t).first;
    const Vector3d like_velocity = curve_jet<3>(like.shape, t).first;
    // A curve that runs back has a speed below 0.
    const double speed = std::copysign(velocity.norm(), velocity.dot(like_velocity));
    if (speed == 0.0) continue;
    const double wanted = like_velocity.norm() / shape_length;
    work(t, velocity / speed, speed / like.length - wanted);
  }
}

}  // namespace

double speed_error(Points points, const CurveTemplate& like) {
  double squares = 0.0;
  int count = 0;
  for_speeds(points, like, [&](double, const Vector3d&, double error) {
    squares += error * error;
    ++count;
  });
  return count == 0 ? 0.0 : std::sqrt(squares / count);
}

void add_speed_rows(const CurveUnknowns& unknowns, int curve, Points points,
                    const CurveTemplate& like, double speed_tolerance, NormalEquations& equations) {
  const int degree = int(points.size()) - 1;
  CurveRows rows(unknowns, curve);
  for_speeds(points, like, [&](double t, const Vector3d& direction, double error) {
    rows.add(model::bernstein(degree, t).d[1], direction, like.length * error,
             1.0 / (speed_tolerance * like.length));
  });
  rows.add_to(equations);
}

void add_shape_rows(const CurveUnknowns& unknowns, int curve, Points points,
                    const CurveTemplate& like, NormalEquations& equations) {
  const int degree = int(points.size()) - 1;
  CurveRows rows(unknowns, curve);
  for (int i = 0; i <= degree; ++i) {
    const bool inner = i > 0 && i < degree;
    std::vector<double> basis(std::size_t(degree) + 1, 0.0);
    basis[i] = 1.0;
    // Inner points count relative to the line between the ends.
    if (inner) basis.front() = double(i) / degree - 1.0, basis.back() = -double(i) / degree;
    Vector3d off(0.0, 0.0, 0.0);
    for (int j = 0; j <= degree; ++j) off += basis[j] * (points[j] - like.shape[j]);
    const double error = inner ? like.tolerance * std::max(like.length, 1.0) : vertex_error;
    for (int axis = 0; axis < 3; ++axis)
      rows.add(basis, Vector3d::Unit(axis), off[axis], 1.0 / error);
  }
  rows.add_to(equations);
}

void add_template_rows(const CurveUnknowns& unknowns, int curve, Points points,
                       const CurveTemplate& like, double speed_tolerance,
                       NormalEquations& equations) {
  add_speed_rows(unknowns, curve, points, like, speed_tolerance, equations);
  add_shape_rows(unknowns, curve, points, like, equations);
}

}  // namespace bodyline::sketch
