#include "io/body_net.hpp"

#include "io/export_sides.hpp"

namespace bodyline::io {
namespace {

model::SplineCurve side_curve(const model::Surface& surface, model::Side side) {
  std::vector<Eigen::Vector3d> points = side_points(surface, side);
  const int degree = static_cast<int>(points.size()) - 1;
  return {degree, {0.0, 1.0}, std::move(points)};
}

model::NetFace net_face(const model::Surface& surface) {
  model::NetFace face;
  face.surface = {surface.name, surface.degree_u, surface.degree_v, {0.0, 1.0},
                  {0.0, 1.0},   surface.net,      surface.blend};
  face.inward = surface.inward;
  return face;
}

}  // namespace

model::FaceNet body_net(const std::vector<model::Surface>& faces, const std::string& name) {
  const SideGraph graph = match_sides(faces);
  model::FaceNet net;
  net.name = name;
  net.vertices = graph.vertices;
  std::vector<int> edge_of_curve(graph.curves.size(), -1);
  for (std::size_t c = 0; c < graph.curves.size(); ++c) {
    const SharedCurve& curve = graph.curves[c];
    if (curve.degenerate) continue;
    edge_of_curve[c] = static_cast<int>(net.edges.size());
    const SideUse& first = curve.uses.front();
    net.edges.push_back({side_curve(faces[first.face], first.side), curve.start, curve.end});
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    net.faces.push_back(net_face(faces[f]));
    net.faces.back().corners = graph.face_vertex[f];
    for (const model::Side side : model::all_sides) {
      const int s = static_cast<int>(side);
      const int edge = edge_of_curve[graph.side_curve[f][s]];
      if (edge >= 0) net.faces.back().sides[s] = {{edge, graph.side_against[f][s], 0.0, 1.0}};
    }
  }
  return net;
}

}  // namespace bodyline::io
