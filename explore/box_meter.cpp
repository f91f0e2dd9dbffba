#include "explore/box_meter.hpp"

#include <algorithm>
#include <limits>

#include "explore/bernstein_maximum.hpp"
#include "model/measures_extreme.hpp"
#include "model/net_surface.hpp"

namespace bodyline::explore {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int search_cells = 24;

int point_count(const model::Face& face) { return (face.degree_u + 1) * (face.degree_v + 1); }

double polynomial_maximum(const model::Face& face, const double* nets, int axis, double sign,
                          double best) {
  BernsteinPatch patch;
  patch.degree_u = face.degree_u;
  patch.degree_v = face.degree_v;
  for (int k = 0; k < point_count(face); ++k) patch.c[k] = sign * nets[3 * (face.net + k) + axis];
  return maximum(patch, best);
}

// With a Gregory term a face is no polynomial; such faces are small and hardly ever the furthest.
double rational_maximum(const model::Face& face, const double* nets, int axis, double sign,
                        double best) {
  const model::Surface surface = model::net_surface(face, nets);
  const auto value = [&](double u, double v) { return sign * jet(surface, u, v, 0).d[0][axis]; };
  return std::max(best, model::largest_value(value, search_cells).value);
}

}  // namespace

BoxMeter::BoxMeter(const model::BodyPlan& plan) : plan_(&plan), bounds_(plan.body_faces.size()) {}

double BoxMeter::furthest(const double* nets, int axis, double sign) const {
  const std::vector<model::Face>& faces = plan_->body_faces;
  const auto bound = [&](std::size_t f) {
    return sign > 0.0 ? bounds_[f].high[axis] : -bounds_[f].low[axis];
  };
  double best = -infinity;  // corners of nets are points of faces
  for (const model::Face& face : faces) {
    const int row = face.degree_v + 1;
    for (const int k : {0, face.degree_v, face.degree_u * row, face.degree_u * row + face.degree_v})
      best = std::max(best, sign * nets[3 * (face.net + k) + axis]);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (bound(f) <= best) continue;
    best = faces[f].blend < 0 ? polynomial_maximum(faces[f], nets, axis, sign, best)
                              : rational_maximum(faces[f], nets, axis, sign, best);
  }
  return sign * best;
}

BodyReach BoxMeter::measure(const double* nets) {
  // An upper bound of |g| for the Gregory term of model/surface.hpp.
  constexpr double largest_blend = 0.022;
  for (std::size_t f = 0; f < bounds_.size(); ++f) {
    const model::Face& face = plan_->body_faces[f];
    Bounds bounds{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    const double* point = nets + 3 * face.net;
    for (int k = 0; k < point_count(face); ++k, point += 3) {
      for (int axis = 0; axis < 3; ++axis) {
        bounds.low[axis] = std::min(bounds.low[axis], point[axis]);
        bounds.high[axis] = std::max(bounds.high[axis], point[axis]);
      }
    }
    for (int axis = 0; axis < 3 && face.blend >= 0; ++axis) {
      const double more = largest_blend * std::abs(nets[3 * face.blend + axis]);
      bounds.low[axis] -= more;
      bounds.high[axis] += more;
    }
    bounds_[f] = bounds;
  }
  BodyReach reach;
  reach.front = furthest(nets, 0, -1.0);
  reach.rear = furthest(nets, 0, 1.0);
  reach.side = std::max(-furthest(nets, 1, -1.0), furthest(nets, 1, 1.0));
  reach.bottom = furthest(nets, 2, -1.0);
  reach.top = furthest(nets, 2, 1.0);
  return reach;
}

}  // namespace bodyline::explore
