#include "strokes/refined_body.hpp"

#include <algorithm>
#include <stdexcept>

#include "strokes/face_net.hpp"

namespace bodyline::strokes {
namespace {

using model::FaceNet;
using model::NetFace;
using model::NetSidePart;
using model::Side;

void mirror(FaceNet& net) {
  const auto turn = [](std::vector<Eigen::Vector3d>& points) {
    for (Eigen::Vector3d& point : points) point.y() = -point.y();
  };
  turn(net.vertices);
  for (model::NetEdge& edge : net.edges) turn(edge.curve.points);
  for (NetFace& face : net.faces) turn(face.surface.net);
}

/// Appends what the parts are made of; their corners are those of the face.
class Replacement {
 public:
  Replacement(const FaceNet& body, int face, const FaceNet& parts, std::vector<BorderPart> border)
      : net_(body), old_(body.faces[face]), border_(std::move(border)) {
    for (const auto& side : old_.sides)
      if (side.size() != 1)
        throw std::invalid_argument(old_.surface.name + " cannot be refined: a side of it is " +
                                    std::to_string(side.size()) + " edges instead of one");
    first_edge_ = static_cast<int>(net_.edges.size());
    append_vertices(parts);
    for (const model::NetEdge& edge : parts.edges)
      net_.edges.push_back({edge.curve, vertex_[edge.start], vertex_[edge.end]});
    meet_neighbours(face);
    replace_face(face, parts);
    drop_unused_edges();
  }
  FaceNet take() { return std::move(net_); }

 private:
  void append_vertices(const FaceNet& parts) {
    vertex_.assign(parts.vertices.size(), -1);
    for (const BorderPart& part : border_) {
      const auto corners = model::side_corners(part.side);
      const model::NetEdge& edge = parts.edges[part.edge];
      const int first = part.reversed ? edge.end : edge.start,
                last = part.reversed ? edge.start : edge.end;
      if (part.from <= same_place) vertex_[first] = old_.corners[corners[0]];
      if (part.to >= 1.0 - same_place) vertex_[last] = old_.corners[corners[1]];
    }
    for (std::size_t k = 0; k < parts.vertices.size(); ++k) {
      if (vertex_[k] >= 0) continue;
      vertex_[k] = static_cast<int>(net_.vertices.size());
      net_.vertices.push_back(parts.vertices[k]);
    }
  }

  // Parts of a side in the direction of its running parameter, or against it.
  std::vector<NetSidePart> parts_of(Side side, bool against, double from, double to) const {
    std::vector<NetSidePart> parts;
    for (const BorderPart& part : border_) {
      if (part.side != side) continue;
      const double low = against ? 1.0 - part.to : part.from,
                   high = against ? 1.0 - part.from : part.to;
      parts.push_back({first_edge_ + part.edge, part.reversed != against, from + low * (to - from),
                       from + high * (to - from)});
    }
    std::sort(parts.begin(), parts.end(),
              [](const NetSidePart& a, const NetSidePart& b) { return a.from < b.from; });
    for (std::size_t k = 1; k < parts.size(); ++k) parts[k].from = parts[k - 1].to;
    parts.front().from = from;
    parts.back().to = to;
    return parts;
  }

  void meet_neighbours(int face) {
    for (const Side side : model::all_sides) {
      for (const NetSidePart& own : old_.sides[static_cast<int>(side)]) {
        for (int f = 0; f < static_cast<int>(net_.faces.size()); ++f) {
          if (f == face) continue;
          for (auto& along : net_.faces[f].sides) {
            const auto met = std::find_if(along.begin(), along.end(), [&](const NetSidePart& part) {
              return part.edge == own.edge;
            });
            if (met == along.end()) continue;
            const auto parts = parts_of(side, met->reversed != own.reversed, met->from, met->to);
            along.insert(along.erase(met), parts.begin(), parts.end());
          }
        }
      }
    }
  }

  void replace_face(int face, const FaceNet& parts) {
    std::vector<NetFace> faces = parts.faces;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      faces[k].surface.name = old_.surface.name + " " + std::to_string(k + 1);
      faces[k].inward = old_.inward;
      for (int& corner : faces[k].corners) corner = vertex_[corner];
      for (auto& along : faces[k].sides)
        for (NetSidePart& part : along) part.edge += first_edge_;
    }
    const auto at = net_.faces.erase(net_.faces.begin() + face);
    net_.faces.insert(at, faces.begin(), faces.end());
  }

  void drop_unused_edges() {
    std::vector<int> number(net_.edges.size(), -1);
    std::vector<model::NetEdge> kept;
    for (NetFace& face : net_.faces) {
      for (auto& along : face.sides) {
        for (NetSidePart& part : along) {
          if (number[part.edge] < 0) {
            number[part.edge] = static_cast<int>(kept.size());
            kept.push_back(net_.edges[part.edge]);
          }
          part.edge = number[part.edge];
        }
      }
    }
    net_.edges = std::move(kept);
  }

  FaceNet net_;
  NetFace old_;
  std::vector<BorderPart> border_;
  int first_edge_ = 0;
  std::vector<int> vertex_;  // of the body, by vertex of the parts
};

}  // namespace

FaceNet refined_body(const FaceNet& body, int face, const Net& refinement) {
  return Replacement(body, face, face_net(refinement, ""), border_parts(refinement)).take();
}

FaceNet refined_mirror_image(const FaceNet& body, int face, const Net& refinement) {
  FaceNet parts = face_net(refinement, "");
  mirror(parts);
  return Replacement(body, face, parts, border_parts(refinement)).take();
}

}  // namespace bodyline::strokes
