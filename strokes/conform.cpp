#include "strokes/conform.hpp"

#include <Eigen/Geometry>

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;
using model::CurveJet;
using model::SplineCurve;

constexpr double step = 1e-4;  // of a parameter, for slopes of normals
constexpr double too_steep = 1e-3;

// Derivatives as the vertex's frame wants them: turned into its plane at equal length, curved as
// its form says.
CurveJet wanted(const CurveJet& jet, const Vertex& vertex, const Vector3d& towards) {
  const Vector3d& n = vertex.frame.normal;
  Vector3d first = jet.first - n.dot(jet.first) * n;
  if (first.norm() < too_steep * jet.first.norm()) first = towards - n.dot(towards) * n;
  if (first.norm() > 0.0) first *= jet.first.norm() / first.norm();
  const Vector3d second =
      jet.second - n.dot(jet.second) * n + first.dot(vertex.frame.form * first) * n;
  return {vertex.point, first, second};
}

CurveJet difference(const CurveJet& a, const CurveJet& b) {
  return {a.point - b.point, a.first - b.first, a.second - b.second};
}

/// D = n x C' and D' = n x C'' + (C'.W D) n.
CurveJet across_at_vertex(const CurveJet& along, const Frame& frame) {
  const Vector3d& n = frame.normal;
  const Vector3d across = n.cross(along.first);
  return {across, n.cross(along.second) + along.first.dot(frame.form * across) * n,
          Vector3d::Zero()};
}

}  // namespace

NormalField edge_normals(const Edge& edge) {
  return [curve = edge.curve, across = edge.across](double t) {
    return Vector3d(
        model::curve_jet(curve, t).first.cross(model::curve_point(across, t)).normalized());
  };
}

SplineCurve across_field(const SplineCurve& curve, const NormalField& normals, const Frame& begin,
                         const Frame& end) {
  const Vector3d at_begin = begin.normal - normals(0.0), at_end = end.normal - normals(1.0);
  const auto across = [&](double t) {
    const Vector3d first = model::curve_jet(curve, t).first;
    const Vector3d normal = normals(t) + (1.0 - t) * at_begin + t * at_end;
    const Vector3d square = normal - normal.dot(first) / first.squaredNorm() * first;
    return Vector3d(square.normalized().cross(first));
  };
  std::vector<CurveJet> jets{across_at_vertex(model::curve_jet(curve, 0.0), begin)};
  for (int k = 1; k < curve.pieces(); ++k) {
    const double t = curve.breaks[k];
    jets.push_back(
        {across(t), (across(t + step) - across(t - step)) / (2.0 * step), Vector3d::Zero()});
  }
  jets.push_back(across_at_vertex(model::curve_jet(curve, 1.0), end));
  SplineCurve field{3, curve.breaks, {jets.front().point}};
  for (int k = 0; k < curve.pieces(); ++k) {
    const double length = curve.breaks[k + 1] - curve.breaks[k];
    CurveJet from = jets[k], to = jets[k + 1];
    from.first *= length;
    to.first *= length;
    const SplineCurve piece = model::cubic(from, to);
    field.points.insert(field.points.end(), piece.points.begin() + 1, piece.points.end());
  }
  return field;
}

void conform(NetEdit& edit, int index, const NormalField& normals) {
  const Net& net = edit.net();
  Edge& edge = edit.edge(index);
  const Vertex &start = net.vertices[edge.start], &end = net.vertices[edge.end];
  const Vector3d chord = end.point - start.point;
  const CurveJet begin_jet = model::curve_jet(edge.curve, 0.0);
  const CurveJet end_jet = model::curve_jet(edge.curve, 1.0);
  const SplineCurve bend = model::quintic(difference(wanted(begin_jet, start, chord), begin_jet),
                                          difference(wanted(end_jet, end, chord), end_jet));
  edge.curve = model::curve_sum(1.0, edge.curve, 1.0, bend);
  edge.curve.points.front() = start.point;
  edge.curve.points.back() = end.point;
  edge.across = across_field(edge.curve, normals, start.frame, end.frame);
}

}  // namespace bodyline::strokes
