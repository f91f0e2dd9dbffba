#include "strokes/face_net.hpp"

#include <algorithm>
#include <numeric>

#include "strokes/coons_shape.hpp"

namespace bodyline::strokes {
namespace {

using model::Side;

// Sides of a shape in the order t = 0, s = 1, t = 1, s = 0; u is s and v is t.
constexpr Side side_of_shape[4] = {Side::v0, Side::u1, Side::v1, Side::u0};

// A side's edges in the direction of its running parameter, which on v1 and u0 is against the walk
// around the patch.
std::vector<model::NetSidePart> side_parts(const Net& net, std::vector<EdgeUse> uses,
                                           bool against) {
  if (against) {
    std::reverse(uses.begin(), uses.end());
    for (EdgeUse& use : uses) use.reversed = !use.reversed;
  }
  double whole = 0.0, reached = 0.0;
  for (const EdgeUse& use : uses) whole += domain_length(net, net.edges[use.edge]);
  std::vector<model::NetSidePart> parts;
  for (const EdgeUse& use : uses) {
    const double from = reached / whole;
    reached += domain_length(net, net.edges[use.edge]);
    parts.push_back({use.edge, use.reversed, from, reached / whole});
  }
  parts.back().to = 1.0;
  return parts;
}

model::NetFace net_face(const Net& net, const Patch& patch, const std::string& name) {
  model::NetFace face;
  face.surface = patch.shape->spline_face();
  face.surface.name = name;
  for (int k = 0; k < 4; ++k) {
    const int side = patch_side(patch, k);
    const bool against = k >= 2;
    if (side >= 0)
      face.sides[static_cast<int>(side_of_shape[k])] = side_parts(net, patch.sides[side], against);
  }
  const std::size_t corners = patch.sides.size();
  for (std::size_t k = 0; k < 4; ++k)
    face.corners[k] = first_vertex(net, patch.sides[std::min(k, corners - 1)]);
  return face;
}

}  // namespace

model::FaceNet face_net(const Net& net, const std::string& name) {
  model::FaceNet faces;
  faces.name = name;
  for (const Vertex& vertex : net.vertices) faces.vertices.push_back(vertex.point);
  for (const Edge& edge : net.edges) faces.edges.push_back({edge.curve, edge.start, edge.end});
  for (const Patch& patch : net.patches)
    faces.faces.push_back(net_face(net, patch, "patch " + std::to_string(faces.faces.size() + 1)));
  return faces;
}

}  // namespace bodyline::strokes
