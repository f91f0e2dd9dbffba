#include "io/export_shell.hpp"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

#include "io/export_sides.hpp"
#include "io/export_spline.hpp"
#include "model/face_net.hpp"

namespace bodyline::io {
namespace {

using model::Side;

gp_Pnt to_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

Handle(Geom_BSplineCurve) to_geometry(const std::vector<Eigen::Vector3d>& points) {
  const int count = static_cast<int>(points.size());
  TColgp_Array1OfPnt poles(1, count);
  for (int k = 0; k < count; ++k) poles(k + 1) = to_point(points[k]);
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0.0;
  knots(2) = 1.0;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(count);
  return new Geom_BSplineCurve(poles, knots, multiplicities, count - 1);
}

/// The straight line in a face's parameters that an edge with parameter 0 to 1 follows.
Handle(Geom2d_Line) parameter_line(Side side, bool reversed) {
  const Eigen::Vector2d from = side_parameters(side, reversed ? 1.0 : 0.0);
  const Eigen::Vector2d to = side_parameters(side, reversed ? 0.0 : 1.0);
  return new Geom2d_Line(gp_Pnt2d(from.x(), from.y()),
                         gp_Dir2d(to.x() - from.x(), to.y() - from.y()));
}

std::vector<TopoDS_Vertex> make_vertices(const SideGraph& graph,
                                         const std::vector<model::Surface>& surfaces) {
  std::vector<double> tolerance(graph.vertices.size(), least_cad_tolerance_mm);
  for (const SharedCurve& curve : graph.curves) {
    for (const SideUse& use : curve.uses) {
      const auto points = side_points(surfaces[use.face], use.side);
      const auto corners = side_corners(use.side);
      for (int end : {0, 1}) {
        const int vertex = graph.face_vertex[use.face][corners[end]];
        const Eigen::Vector3d& p = end == 0 ? points.front() : points.back();
        tolerance[vertex] = std::max(tolerance[vertex], 2.0 * (p - graph.vertices[vertex]).norm());
      }
    }
  }
  std::vector<TopoDS_Vertex> vertices(graph.vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k)
    BRep_Builder().MakeVertex(vertices[k], to_point(graph.vertices[k]), tolerance[k]);
  return vertices;
}

TopoDS_Edge make_edge(const SharedCurve& curve, const std::vector<model::Surface>& surfaces,
                      const std::vector<TopoDS_Face>& faces,
                      const std::vector<TopoDS_Vertex>& vertices) {
  BRep_Builder builder;
  TopoDS_Edge edge;
  const double tolerance = std::max(least_cad_tolerance_mm, 2.0 * curve.gap_mm);
  const SideUse& first = curve.uses[0];
  if (curve.degenerate) {
    builder.MakeEdge(edge);
  } else {
    builder.MakeEdge(edge, to_geometry(side_points(surfaces[first.face], first.side)), tolerance);
  }
  for (const SideUse& use : curve.uses)
    builder.UpdateEdge(edge, parameter_line(use.side, use.reversed), faces[use.face], tolerance);
  builder.Add(edge, vertices[curve.start].Oriented(TopAbs_FORWARD));
  builder.Add(edge, vertices[curve.end].Oriented(TopAbs_REVERSED));
  builder.Range(edge, 0.0, 1.0);
  builder.Degenerated(edge, curve.degenerate);
  return edge;
}

/// The boundary of a face, counter-clockwise in its parameters.
TopoDS_Wire make_wire(const SideGraph& graph, int face, const std::vector<TopoDS_Edge>& edges) {
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (Side side : {Side::v0, Side::u1, Side::v1, Side::u0}) {
    const int s = static_cast<int>(side);
    const bool backwards = side == Side::v1 || side == Side::u0;
    const bool forward = backwards == graph.side_against[face][s];
    builder.Add(wire, edges[graph.side_curve[face][s]].Oriented(forward ? TopAbs_FORWARD
                                                                        : TopAbs_REVERSED));
  }
  wire.Closed(true);
  return wire;
}

/// For every face the first face that hangs together with it along shared curves.
std::vector<int> connected_parts(const SideGraph& graph, std::size_t faces) {
  std::vector<int> part(faces);
  std::iota(part.begin(), part.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (const SharedCurve& curve : graph.curves) {
      if (curve.uses.size() < 2) continue;
      int& a = part[curve.uses[0].face];
      int& b = part[curve.uses[1].face];
      changed = changed || a != b;
      a = b = std::min(a, b);
    }
  }
  return part;
}

}  // namespace

Handle(Geom_BSplineSurface) to_geometry(const SplineSurface& spline) {
  TColgp_Array2OfPnt net(1, spline.count_u, 1, spline.count_v);
  for (int i = 0; i < spline.count_u; ++i)
    for (int j = 0; j < spline.count_v; ++j) net(i + 1, j + 1) = to_point(spline.point(i, j));
  const int breaks = static_cast<int>(spline.breaks.size());
  TColStd_Array1OfReal knots(1, breaks);
  TColStd_Array1OfInteger in_u(1, breaks), in_v(1, breaks);
  for (int k = 1; k <= breaks; ++k) {
    const bool end = k == 1 || k == breaks;
    knots(k) = spline.breaks[k - 1];
    in_u(k) = end ? spline.degree_u + 1 : 1;
    in_v(k) = end ? spline.degree_v + 1 : 1;
  }
  return new Geom_BSplineSurface(net, knots, knots, in_u, in_v, spline.degree_u, spline.degree_v);
}

std::vector<std::string> face_names(const std::vector<model::Surface>& surfaces) {
  std::vector<std::string> names;
  for (const model::Surface& surface : surfaces) names.push_back(surface.name);
  return names;
}

TopoDS_Shape collect_shells(const std::vector<TopoDS_Face>& faces, const std::vector<int>& part) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  std::map<int, TopoDS_Shell> shells;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    TopoDS_Shell& shell = shells[part[f]];
    if (shell.IsNull()) builder.MakeShell(shell);
    builder.Add(shell, faces[f]);
  }
  for (auto& [first, shell] : shells) {
    shell.Closed(BRep_Tool::IsClosed(shell));
    builder.Add(compound, shell);
  }
  if (shells.size() == 1) return shells.begin()->second;
  return compound;
}

void refuse_invalid(const TopoDS_Shape& shape) {
  const BRepCheck_Analyzer check(shape);
  if (!check.IsValid())
    throw std::runtime_error("the faces do not make a valid shell for OpenCASCADE");
}

struct QuietCad::Printers {
  Message_SequenceOfPrinters sequence;
};

QuietCad::QuietCad() : printers_(new Printers{Message::DefaultMessenger()->Printers()}) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
}

QuietCad::~QuietCad() {
  Message::DefaultMessenger()->ChangePrinters() = printers_->sequence;
  delete printers_;
}

CadShell make_shell(const std::vector<model::Surface>& surfaces) {
  const SideGraph graph = match_sides(surfaces);
  BRep_Builder builder;
  CadShell result;
  result.faces.resize(surfaces.size());
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    const SplineSurface spline = spline_surface(surfaces[f]);
    result.max_deviation_mm = std::max(result.max_deviation_mm, spline.deviation_mm);
    if (spline.deviation_mm > 0.0) result.not_polynomial.push_back(surfaces[f].name);
    builder.MakeFace(result.faces[f], to_geometry(spline), least_cad_tolerance_mm);
  }
  const std::vector<TopoDS_Vertex> vertices = make_vertices(graph, surfaces);
  std::vector<TopoDS_Edge> edges;
  for (const SharedCurve& curve : graph.curves)
    edges.push_back(make_edge(curve, surfaces, result.faces, vertices));
  for (int f = 0; f < static_cast<int>(surfaces.size()); ++f) {
    builder.Add(result.faces[f], make_wire(graph, f, edges));
    if (surfaces[f].inward) result.faces[f].Reverse();
  }
  result.shape = collect_shells(result.faces, connected_parts(graph, surfaces.size()));
  refuse_invalid(result.shape);
  return result;
}

}  // namespace bodyline::io
