#include "strokes/net.hpp"

#include <algorithm>

namespace bodyline::strokes {

int first_vertex(const Net& net, const EdgeUse& use) {
  const Edge& edge = net.edges[use.edge];
  return use.reversed ? edge.end : edge.start;
}

int last_vertex(const Net& net, const EdgeUse& use) {
  const Edge& edge = net.edges[use.edge];
  return use.reversed ? edge.start : edge.end;
}

int first_vertex(const Net& net, const std::vector<EdgeUse>& side) {
  return first_vertex(net, side.front());
}

bool is_outer(const Edge& edge) { return edge.left < 0 || edge.right < 0; }

bool is_outer(const Net& net, const Vertex& vertex) {
  return std::any_of(vertex.edges.begin(), vertex.edges.end(),
                     [&](int edge) { return is_outer(net.edges[edge]); });
}

bool is_drawn(const Edge& edge, double t) {
  return edge.drawn_from < edge.drawn_to && t >= edge.drawn_from && t <= edge.drawn_to;
}

bool is_drawn(const Net& net, int vertex) {
  const std::vector<int>& edges = net.vertices[vertex].edges;
  return std::any_of(edges.begin(), edges.end(), [&](int index) {
    const Edge& edge = net.edges[index];
    return is_drawn(edge, edge.start == vertex ? 0.0 : 1.0);
  });
}

double domain_length(const Net& net, const Edge& edge) {
  return (net.vertices[edge.end].place - net.vertices[edge.start].place).norm();
}

Eigen::Vector2d domain_place(const Net& net, const Edge& edge, double t) {
  const Eigen::Vector2d &a = net.vertices[edge.start].place, &b = net.vertices[edge.end].place;
  return a + t * (b - a);
}

Polygon polygon(const Net& net, const Patch& patch) {
  Polygon corners;
  for (const auto& side : patch.sides)
    corners.push_back(net.vertices[first_vertex(net, side)].place);
  return corners;
}

double domain_area(const Net& net) {
  double sum = 0.0;
  for (const Patch& patch : net.patches) sum += area(polygon(net, patch));
  return sum;
}

model::SplineCurve side_curve(const Net& net, const std::vector<EdgeUse>& side) {
  std::vector<model::SplineCurve> curves;
  std::vector<double> lengths;
  for (const EdgeUse& use : side) {
    const Edge& edge = net.edges[use.edge];
    curves.push_back(use.reversed ? model::reversed_curve(edge.curve) : edge.curve);
    lengths.push_back(domain_length(net, edge));
  }
  return curves.size() == 1 ? curves.front() : model::joined_curves(curves, lengths);
}

}  // namespace bodyline::strokes
