#include "io/net_shell.hpp"

#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <numeric>

#include "io/export_sides.hpp"
#include "model/face_pieces.hpp"

namespace bodyline::io {
namespace {

using model::NetFace;
using model::NetSidePart;
using model::Side;

// A knot loses one of its multiplicity where the surface stays within this of itself. Between
// pieces of very different sizes that is left alone: OpenCASCADE divides by the smaller.
constexpr double knot_tolerance_mm = 1e-8;
constexpr double least_piece_ratio = 1e-3;
constexpr int gap_samples = 9;

gp_Pnt to_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;

  Knots(const std::vector<double>& breaks, int degree)
      : values(1, static_cast<int>(breaks.size())),
        multiplicities(1, static_cast<int>(breaks.size())) {
    for (int k = 1; k <= values.Upper(); ++k) {
      values(k) = breaks[k - 1];
      multiplicities(k) = k == 1 || k == values.Upper() ? degree + 1 : degree;
    }
  }
};

// Whether a net of rows of points, one piece of `degree` behind the other, has equal derivatives on
// both sides of a break. `point(k, l)` is point k of row l.
template <class PointAt>
bool is_smooth(const std::vector<double>& breaks, int at, int degree, int rows, PointAt&& point) {
  const double before = breaks[at] - breaks[at - 1], behind = breaks[at + 1] - breaks[at];
  if (std::min(before, behind) < least_piece_ratio * std::max(before, behind)) return false;
  for (int l = 0; l < rows; ++l) {
    const Eigen::Vector3d in = (point(at * degree, l) - point(at * degree - 1, l)) / before;
    const Eigen::Vector3d out = (point(at * degree + 1, l) - point(at * degree, l)) / behind;
    if ((in - out).norm() * std::min(before, behind) > knot_tolerance_mm) return false;
  }
  return true;
}

bool is_smooth_in_u(const model::SplineFace& face, int at) {
  return is_smooth(face.breaks_u, at, face.degree_u, face.count_v(),
                   [&](int k, int l) { return face.point(k, l); });
}

bool is_smooth_in_v(const model::SplineFace& face, int at) {
  return is_smooth(face.breaks_v, at, face.degree_v, face.count_u(),
                   [&](int k, int l) { return face.point(l, k); });
}

Handle(Geom_BSplineSurface) to_geometry(const model::SplineFace& face) {
  TColgp_Array2OfPnt net(1, face.count_u(), 1, face.count_v());
  for (int i = 0; i < face.count_u(); ++i)
    for (int j = 0; j < face.count_v(); ++j) net(i + 1, j + 1) = to_point(face.point(i, j));
  const Knots u(face.breaks_u, face.degree_u), v(face.breaks_v, face.degree_v);
  Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(
      net, u.values, v.values, u.multiplicities, v.multiplicities, face.degree_u, face.degree_v);
  for (int k = static_cast<int>(face.breaks_u.size()) - 1; k > 1; --k)
    if (is_smooth_in_u(face, k - 1)) surface->RemoveUKnot(k, face.degree_u - 1, knot_tolerance_mm);
  for (int k = static_cast<int>(face.breaks_v.size()) - 1; k > 1; --k)
    if (is_smooth_in_v(face, k - 1)) surface->RemoveVKnot(k, face.degree_v - 1, knot_tolerance_mm);
  return surface;
}

Handle(Geom_BSplineCurve) to_geometry(const model::SplineCurve& curve) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(curve.points.size()));
  for (int k = 1; k <= poles.Upper(); ++k) poles(k) = to_point(curve.points[k - 1]);
  const Knots knots(curve.breaks, curve.degree);
  return new Geom_BSplineCurve(poles, knots.values, knots.multiplicities, curve.degree);
}

/// A use of an edge by a face.
struct EdgeFace {
  int face = -1;
  Side side = Side::u0;
  NetSidePart part;

  /// Parameters of the face where the edge is at t.
  Eigen::Vector2d parameters(double t) const {
    const double along = part.reversed ? 1.0 - t : t;
    return side_parameters(side, part.from + along * (part.to - part.from));
  }
};

Handle(Geom2d_BSplineCurve) parameter_line(const EdgeFace& use) {
  TColgp_Array1OfPnt2d poles(1, 2);
  const Eigen::Vector2d from = use.parameters(0.0), to = use.parameters(1.0);
  poles(1) = {from.x(), from.y()};
  poles(2) = {to.x(), to.y()};
  const Knots knots({0.0, 1.0}, 1);
  return new Geom2d_BSplineCurve(poles, knots.values, knots.multiplicities, 1);
}

std::vector<std::vector<EdgeFace>> uses_by_edge(const model::FaceNet& net) {
  std::vector<std::vector<EdgeFace>> uses(net.edges.size());
  for (int f = 0; f < static_cast<int>(net.faces.size()); ++f)
    for (const Side side : model::all_sides)
      for (const NetSidePart& part : net.faces[f].sides[static_cast<int>(side)])
        uses[part.edge].push_back({f, side, part});
  return uses;
}

double largest_gap(const model::SplineCurve& curve, const std::vector<EdgeFace>& uses,
                   const std::vector<model::FacePieces>& pieces) {
  double gap = 0.0;
  for (const EdgeFace& use : uses) {
    for (int k = 0; k < gap_samples; ++k) {
      const double t = static_cast<double>(k) / (gap_samples - 1);
      const Eigen::Vector2d uv = use.parameters(t);
      const Eigen::Vector3d there = pieces[use.face].jet(uv.x(), uv.y(), 0).d[0];
      gap = std::max(gap, (there - model::curve_point(curve, t)).norm());
    }
  }
  return gap;
}

/// All that a shell is made of, by number of the net.
struct Parts {
  std::vector<TopoDS_Vertex> vertices;
  std::vector<TopoDS_Edge> edges;
  std::vector<TopoDS_Face> faces;
};

TopoDS_Edge make_edge(const model::NetEdge& edge, const std::vector<EdgeFace>& uses, double gap,
                      const Parts& parts) {
  BRep_Builder builder;
  TopoDS_Edge result;
  const double tolerance = std::max(least_cad_tolerance_mm, 2.0 * gap);
  builder.MakeEdge(result, to_geometry(edge.curve), tolerance);
  for (const EdgeFace& use : uses)
    builder.UpdateEdge(result, parameter_line(use), parts.faces[use.face], tolerance);
  builder.Add(result, parts.vertices[edge.start].Oriented(TopAbs_FORWARD));
  builder.Add(result, parts.vertices[edge.end].Oriented(TopAbs_REVERSED));
  builder.Range(result, 0.0, 1.0);
  return result;
}

TopoDS_Edge make_point_edge(const NetFace& face, int face_number, Side side, const Parts& parts) {
  BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, parameter_line({face_number, side, {}}), parts.faces[face_number],
                     least_cad_tolerance_mm);
  const TopoDS_Vertex& vertex = parts.vertices[face.corners[side_corners(side)[0]]];
  builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
  builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
  builder.Range(edge, 0.0, 1.0);
  builder.Degenerated(edge, true);
  return edge;
}

TopoDS_Wire make_wire(const NetFace& face, int face_number, const Parts& parts) {
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const Side side : {Side::v0, Side::u1, Side::v1, Side::u0}) {
    const bool backwards = side == Side::v1 || side == Side::u0;
    std::vector<NetSidePart> along = face.sides[static_cast<int>(side)];
    if (backwards) std::reverse(along.begin(), along.end());
    for (const NetSidePart& part : along)
      builder.Add(wire, parts.edges[part.edge].Oriented(
                            part.reversed == backwards ? TopAbs_FORWARD : TopAbs_REVERSED));
    if (along.empty())
      builder.Add(wire, make_point_edge(face, face_number, side, parts)
                            .Oriented(backwards ? TopAbs_REVERSED : TopAbs_FORWARD));
  }
  wire.Closed(true);
  return wire;
}

/// The geometry of a face; a Gregory one is approximated, which the shell reports.
Handle(Geom_BSplineSurface)
    face_geometry(const NetFace& face, const model::FacePieces& pieces, CadShell& shell) {
  if (!face.surface.blend) return to_geometry(face.surface);
  const SplineSurface spline = spline_surface(pieces.all().front());
  shell.max_deviation_mm = std::max(shell.max_deviation_mm, spline.deviation_mm);
  shell.not_polynomial.push_back(face.surface.name);
  return to_geometry(spline);
}

std::vector<int> connected_parts(const std::vector<std::vector<EdgeFace>>& uses,
                                 std::size_t faces) {
  std::vector<int> part(faces);
  std::iota(part.begin(), part.end(), 0);
  const auto find = [&part](int f) {
    while (part[f] != f) f = part[f] = part[part[f]];
    return f;
  };
  for (const auto& of_edge : uses)
    for (const EdgeFace& use : of_edge) {
      const int a = find(use.face), b = find(of_edge.front().face);
      part[std::max(a, b)] = std::min(a, b);
    }
  for (int f = 0; f < static_cast<int>(faces); ++f) part[f] = find(f);
  return part;
}

}  // namespace

CadShell make_shell(const model::FaceNet& net) {
  BRep_Builder builder;
  Parts parts;
  std::vector<model::FacePieces> pieces;
  CadShell shell;
  for (const NetFace& face : net.faces) {
    pieces.emplace_back(face);
    parts.faces.emplace_back();
    builder.MakeFace(parts.faces.back(), face_geometry(face, pieces.back(), shell),
                     least_cad_tolerance_mm);
  }
  const auto uses = uses_by_edge(net);
  std::vector<double> gaps, around(net.vertices.size(), 0.0);
  for (std::size_t e = 0; e < net.edges.size(); ++e) {
    gaps.push_back(largest_gap(net.edges[e].curve, uses[e], pieces));
    for (const int end : {net.edges[e].start, net.edges[e].end})
      around[end] = std::max(around[end], gaps.back());
  }
  for (std::size_t k = 0; k < net.vertices.size(); ++k) {
    parts.vertices.emplace_back();
    builder.MakeVertex(parts.vertices.back(), to_point(net.vertices[k]),
                       std::max(least_cad_tolerance_mm, 2.0 * around[k]));
  }
  for (std::size_t e = 0; e < net.edges.size(); ++e)
    parts.edges.push_back(make_edge(net.edges[e], uses[e], gaps[e], parts));
  for (int f = 0; f < static_cast<int>(net.faces.size()); ++f) {
    builder.Add(parts.faces[f], make_wire(net.faces[f], f, parts));
    if (net.faces[f].inward) parts.faces[f].Reverse();
  }
  shell.shape = collect_shells(parts.faces, connected_parts(uses, net.faces.size()));
  shell.faces = parts.faces;
  refuse_invalid(shell.shape);
  return shell;
}

}  // namespace bodyline::io
