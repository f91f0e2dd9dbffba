#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/measures.hpp"
#include "model/measures_extreme.hpp"

namespace bodyline::model {
namespace {

constexpr int search_cells = 24;
// An upper bound of |g| for the Gregory term of surface.hpp: (u (1-u)^2)^2 is at most (4/27)^2.
constexpr double largest_blend = 0.022;

// No point of the face lies further along the axis: a face is inside the hull of its net.
double hull_bound(const Surface& face, int axis, double sign) {
  double bound = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : face.net) bound = std::max(bound, sign * point[axis]);
  if (face.blend) bound += largest_blend * std::abs((*face.blend)[axis]);
  return bound;
}

// The largest value of sign * coordinate over all faces, less than 1e-6 below the true one.
double furthest(const std::vector<Surface>& faces, int axis, double sign) {
  double best = -std::numeric_limits<double>::infinity();
  for (const Surface& face : faces) {
    if (hull_bound(face, axis, sign) <= best) continue;
    const auto value = [&](double u, double v) { return sign * jet(face, u, v, 0).d[0][axis]; };
    best = std::max(best, largest_value(value, search_cells).value);
  }
  return sign * best;
}

}  // namespace

Box bounding_box(const std::vector<Surface>& faces, Halves halves) {
  if (faces.empty()) throw std::invalid_argument("a body without faces has no size");
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = furthest(faces, axis, -1.0);
    box.high[axis] = furthest(faces, axis, 1.0);
  }
  if (halves == Halves::left_and_central) {
    const double half_width = std::max(-box.low.y(), box.high.y());
    box.low.y() = -half_width;
    box.high.y() = half_width;
  }
  return box;
}

}  // namespace bodyline::model
