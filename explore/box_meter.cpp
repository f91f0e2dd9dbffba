#include "explore/box_meter.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "explore/bernstein_maximum.hpp"
#include "model/measures_extreme.hpp"
#include "model/net_surface.hpp"

namespace bodyline::explore {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Bounds = BoxMeter::Bounds;

constexpr int search_cells = 24;
// An upper bound of |g| for the Gregory term of model/surface.hpp.
constexpr double largest_blend = 0.022;

int point_count(const model::Face& face) { return (face.degree_u + 1) * (face.degree_v + 1); }

double smaller(double a, double b) { return a < b ? a : b; }
double larger(double a, double b) { return a > b ? a : b; }

using Pair = double __attribute__((vector_size(16)));

Pair load(const double* at) {
  Pair pair;
  std::memcpy(&pair, at, sizeof pair);
  return pair;
}

// Of so many points one after the other; two points are three pairs of numbers.
Bounds bounds_of(const double* points, int count) {
  const double* const last = points + 3 * (count - 1);
  const double first[6] = {points[0], points[1], points[2], points[0], points[1], points[2]};
  Pair low[3] = {load(first), load(first + 2), load(first + 4)};
  Pair high[3] = {low[0], low[1], low[2]};
  for (const double* p = points; p < last; p += 6) {
    const Pair pairs[3] = {load(p), load(p + 2), load(p + 4)};
    for (int k = 0; k < 3; ++k) low[k] = pairs[k] < low[k] ? pairs[k] : low[k];
    for (int k = 0; k < 3; ++k) high[k] = pairs[k] > high[k] ? pairs[k] : high[k];
  }
  Bounds bounds{{last[0], last[1], last[2]}, {last[0], last[1], last[2]}};
  for (int k = 0; k < 6; ++k) {
    bounds.low[k % 3] = smaller(low[k / 2][k % 2], bounds.low[k % 3]);
    bounds.high[k % 3] = larger(high[k / 2][k % 2], bounds.high[k % 3]);
  }
  return bounds;
}

void widen(Bounds& bounds, const double* point) {
  for (int k = 0; k < 3; ++k) {
    bounds.low[k] = smaller(point[k], bounds.low[k]);
    bounds.high[k] = larger(point[k], bounds.high[k]);
  }
}

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
  const auto reach = [&](const Bounds& bounds) {
    return sign > 0.0 ? bounds.high[axis] : -bounds.low[axis];
  };
  double best = reach(corners_);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (reach(bounds_[f]) <= best) continue;
    best = faces[f].blend < 0 ? polynomial_maximum(faces[f], nets, axis, sign, best)
                              : rational_maximum(faces[f], nets, axis, sign, best);
  }
  return sign * best;
}

void BoxMeter::bound_faces(const double* nets) {
  corners_ = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (std::size_t f = 0; f < bounds_.size(); ++f) {
    const model::Face& face = plan_->body_faces[f];
    const double* const net = nets + 3 * face.net;
    bounds_[f] = bounds_of(net, point_count(face));
    const int row = face.degree_v + 1;
    for (const int k : {0, face.degree_v, face.degree_u * row, face.degree_u * row + face.degree_v})
      widen(corners_, net + 3 * k);
    for (int axis = 0; axis < 3 && face.blend >= 0; ++axis) {
      const double more = largest_blend * std::abs(nets[3 * face.blend + axis]);
      bounds_[f].low[axis] -= more;
      bounds_[f].high[axis] += more;
    }
  }
}

BodyReach BoxMeter::measure(const double* nets) {
  bound_faces(nets);
  BodyReach reach;
  reach.front = furthest(nets, 0, -1.0);
  reach.rear = furthest(nets, 0, 1.0);
  reach.side = std::max(-furthest(nets, 1, -1.0), furthest(nets, 1, 1.0));
  reach.bottom = furthest(nets, 2, -1.0);
  reach.top = furthest(nets, 2, 1.0);
  return reach;
}

}  // namespace bodyline::explore
