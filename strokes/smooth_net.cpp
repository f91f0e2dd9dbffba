#include "strokes/smooth_net.hpp"

#include <limits>

#include "strokes/carrier_edge.hpp"
#include "strokes/smooth_shape.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::SplineCurve;

constexpr double inner_share = 4.0;  // of what edges may be off
constexpr double whole = 1e-9;       // a parameter this close to an end is the end

/// Part of a side of the domain.
struct SidePart {
  std::size_t side = 0;
  double from = 0.0, to = 1.0;
};

double part_along(const Vector2d& a, const Vector2d& b, const Vector2d& place) {
  const double t = nearest_on_line(a, b, place);
  return t < whole ? 0.0 : t > 1.0 - whole ? 1.0 : t;
}

// Edges of the border run with it.
SidePart side_part(const Net& net, const Polygon& domain, const Edge& edge) {
  const Vector2d &from = net.vertices[edge.start].place, &to = net.vertices[edge.end].place;
  SidePart best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < domain.size(); ++k) {
    const Vector2d &a = domain[k], &b = domain[(k + 1) % domain.size()];
    const double at_from = part_along(a, b, from), at_to = part_along(a, b, to);
    const double away = (a + at_from * (b - a) - from).norm() + (a + at_to * (b - a) - to).norm();
    if (away >= least) continue;
    least = away;
    best = {k, at_from, at_to};
  }
  return best;
}

SplineCurve part_of(const SplineCurve& curve, const SidePart& part) {
  return part.from == 0.0 && part.to == 1.0 ? curve : model::curve_part(curve, part.from, part.to);
}

CarrierEdge border_edge(const Net& net, const Carrier& carrier, const Border& border,
                        const Edge& edge, double tolerance_mm) {
  const SidePart part = side_part(net, carrier.basis().domain, edge);
  const SplineCurve curve = part_of(border.curves[part.side], part);
  if (border.across.empty())
    return carrier_edge(carrier, net.vertices[edge.start].place, net.vertices[edge.end].place,
                        curve, tolerance_mm);
  SplineCurve across = part_of(border.across[part.side], part);
  for (Vector3d& point : across.points) point *= part.to - part.from;
  return {curve, across};
}

}  // namespace

Net smooth_net(Net net, const Carrier& carrier, const Border& border, double tolerance_mm) {
  net.smooth = true;
  for (Vertex& vertex : net.vertices) vertex.point = carrier.jet(vertex.place).point;
  for (Edge& edge : net.edges) {
    CarrierEdge on_carrier = is_outer(edge)
                                 ? border_edge(net, carrier, border, edge, tolerance_mm)
                                 : carrier_edge(carrier, net.vertices[edge.start].place,
                                                net.vertices[edge.end].place, tolerance_mm);
    edge.curve = std::move(on_carrier.curve);
    edge.across = std::move(on_carrier.across);
    if (!is_outer(edge)) continue;
    net.vertices[edge.start].point = edge.curve.points.front();
    net.vertices[edge.end].point = edge.curve.points.back();
  }
  for (Edge& edge : net.edges) {
    edge.curve.points.front() = net.vertices[edge.start].point;
    edge.curve.points.back() = net.vertices[edge.end].point;
  }
  for (Patch& patch : net.patches)
    patch.shape = smooth_shape(net, patch, carrier, inner_share * tolerance_mm);
  return net;
}

}  // namespace bodyline::strokes
