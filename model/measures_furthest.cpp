#include "model/measures_furthest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace

Furthest furthest_point(const std::vector<Surface>& faces, int axis, double sign) {
  Furthest best{-1, 0.0, 0.0, -std::numeric_limits<double>::infinity()};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Surface& face = faces[f];
    if (hull_bound(face, axis, sign) <= best.value) continue;
    const auto value = [&](double u, double v) { return sign * jet(face, u, v, 0).d[0][axis]; };
    const Extreme found = largest_value(value, search_cells);
    if (found.value > best.value) best = {int(f), found.u, found.v, found.value};
  }
  best.value *= sign;
  return best;
}

}  // namespace bodyline::model
