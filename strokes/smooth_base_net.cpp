#include "strokes/smooth_base_net.hpp"

#include <Eigen/Geometry>

#include "strokes/base_net.hpp"
#include "strokes/conform.hpp"
#include "strokes/coons_shape.hpp"
#include "strokes/fit_stroke.hpp"
#include "strokes/frame.hpp"
#include "strokes/smooth_shape.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;
using model::CurveJet;

// Below this sine the sides at a corner run on straight, and the loop's own normal serves.
constexpr double straight_sine = 1e-3;

Vector3d loop_normal(const std::vector<Points>& loop) {
  Vector3d sum = Vector3d::Zero();
  const Vector3d origin = loop.front().front();
  for (const Points& side : loop)
    for (std::size_t k = 1; k < side.size(); ++k)
      sum += (side[k - 1] - origin).cross(side[k] - origin);
  return sum.normalized();
}

/// Derivative of the surface across a side, inwards: from the side before to the one behind.
struct Inwards {
  Vector3d at_begin, at_end;
  Vector3d at(double t) const { return (1.0 - t) * at_begin + t * at_end; }
};

Inwards inwards(const Net& net, std::size_t side) {
  const std::size_t count = net.edges.size();
  return {-model::curve_jet(net.edges[(side + count - 1) % count].curve, 1.0).first,
          model::curve_jet(net.edges[(side + 1) % count].curve, 0.0).first};
}

// The frame where side k begins: both curves lie in it, and the twist is the mean of those that the
// derivatives across the two sides have.
Frame corner_frame(const Net& net, std::size_t k, const Vector3d& fallback) {
  const std::size_t count = net.edges.size(), before = (k + count - 1) % count;
  const CurveJet ahead = model::curve_jet(net.edges[k].curve, 0.0);
  const CurveJet behind = model::curve_jet(net.edges[before].curve, 1.0);
  const Vector3d back = -behind.first;
  const Vector3d normal = ahead.first.cross(back);
  Frame frame;
  if (normal.norm() < straight_sine * ahead.first.norm() * back.norm()) {
    frame.normal = fallback;
    return frame_with(frame, ahead.first, ahead.second);
  }
  frame.normal = normal.normalized();
  const Inwards over_ahead = inwards(net, k), over_before = inwards(net, before);
  const Vector3d twist = 0.5 * ((over_ahead.at_end - over_ahead.at_begin) +
                                (over_before.at_begin - over_before.at_end));
  const Vector3d& n = frame.normal;
  frame.form =
      form_from(n, ahead.first, back, n.dot(ahead.second), n.dot(twist), n.dot(behind.second));
  return frame;
}

NormalField side_normals(const Net& net, std::size_t side, const Vector3d& fallback) {
  return [curve = net.edges[side].curve, across = inwards(net, side), fallback](double t) {
    const Vector3d first = model::curve_jet(curve, t).first;
    const Vector3d normal = first.cross(across.at(t));
    return normal.norm() > straight_sine * first.norm() * across.at(t).norm()
               ? Vector3d(normal.normalized())
               : fallback;
  };
}

}  // namespace

Net smooth_base_net(const std::vector<Points>& loop, double tolerance_mm) {
  const int sides = static_cast<int>(loop.size());
  const Polygon domain = base_domain(loop.size());
  const Vector3d fallback = loop_normal(loop);
  Net net;
  net.smooth = true;
  Patch patch;
  for (int k = 0; k < sides; ++k) {
    net.vertices.push_back({domain[k], loop[k].front(), {(k + sides - 1) % sides, k}});
    net.edges.push_back({k, (k + 1) % sides, fit_stroke(loop[k], tolerance_mm).curve, 0, -1, -1});
    patch.sides.push_back({{k, false}});
  }
  for (int k = 0; k < sides; ++k) net.vertices[k].frame = corner_frame(net, k, fallback);
  for (int k = 0; k < sides; ++k)
    net.edges[k].across = across_field(net.edges[k].curve, side_normals(net, k, fallback),
                                       net.vertices[k].frame, net.vertices[(k + 1) % sides].frame);
  net.patches.push_back(std::move(patch));
  turn_to_apex(net, net.patches.front());
  net.patches.front().shape = smooth_shape(net, net.patches.front());
  return net;
}

}  // namespace bodyline::strokes
