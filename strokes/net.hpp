#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "model/spline_curve.hpp"
#include "strokes/patch_shape.hpp"
#include "strokes/polygon.hpp"

/// A surface as a net of patches over a tiling of a plane domain by convex polygons (spec of Qin
/// and Wright's scheme, section 1). Every edge has a straight pre-image; its curve's parameter is
/// the part of the way along it. Patches have three or four straight sides, each a chain of edges:
/// where several meet in a side, patches of the other side end.
namespace bodyline::strokes {

struct Vertex {
  Eigen::Vector2d place;   ///< in the domain
  Eigen::Vector3d point;   ///< mm
  std::vector<int> edges;  ///< that begin or end here
};

struct Edge {
  int start = -1, end = -1;   ///< vertices
  model::SplineCurve curve;   ///< mm
  int left = -1, right = -1;  ///< patches; -1 beyond the outer boundary
  int stroke = -1;            ///< number of the stroke it is a part of; -1 of the boundary
  /// The part of it that was drawn; the rest leads on to the next edge. None where the first is not
  /// below the second.
  double drawn_from = 0.0, drawn_to = 0.0;
  /// Where patches join smoothly: along the curve the derivative of the surface by the pre-image
  /// turned left by a right angle; spans the tangent planes with that by the pre-image. Without
  /// points where patches only meet.
  model::SplineCurve across = {1, {0.0, 1.0}, {}};
};

/// An edge as a patch runs along it, counter-clockwise.
struct EdgeUse {
  int edge = -1;
  bool reversed = false;
};

struct Patch {
  std::vector<std::vector<EdgeUse>> sides;  ///< three or four chains of edges
  std::shared_ptr<const PatchShape> shape;  ///< of its sides as they are
};

struct Net {
  bool smooth = false;  ///< patches join with one tangent plane
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Patch> patches;
};

int first_vertex(const Net& net, const EdgeUse& use);
int last_vertex(const Net& net, const EdgeUse& use);
int first_vertex(const Net& net, const std::vector<EdgeUse>& side);

bool is_outer(const Edge& edge);
/// Whether an edge was drawn at t.
bool is_drawn(const Edge& edge, double t);
/// Whether a vertex lies on the outer boundary.
bool is_outer(const Net& net, const Vertex& vertex);
/// Whether an edge that ends at a vertex was drawn there.
bool is_drawn(const Net& net, int vertex);

/// Length of the pre-image.
double domain_length(const Net& net, const Edge& edge);

/// Where on its pre-image an edge is at t.
Eigen::Vector2d domain_place(const Net& net, const Edge& edge, double t);

/// The corners of a patch in the domain.
Polygon polygon(const Net& net, const Patch& patch);

/// Sum of the areas of all patches in the domain.
double domain_area(const Net& net);

/// A side of a patch as one curve along it, counter-clockwise, with a parameter proportional to
/// the length of the pre-image.
model::SplineCurve side_curve(const Net& net, const std::vector<EdgeUse>& side);

}  // namespace bodyline::strokes
