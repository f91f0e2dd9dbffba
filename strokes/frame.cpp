#include "strokes/frame.hpp"

#include <Eigen/Geometry>

#include "strokes/patch_map.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Below this sine two directions do not span a plane well.
constexpr double parallel_sine = 1e-6;
// Two curves that cross at a smaller sine do not determine the tangent plane.
constexpr double shallow_sine = 0.17;
// Nor do they when it would turn away from the old one by more than this cosine.
constexpr double turned_cosine = 0.5;

// What of a form lies in another plane, which may be turned against its own.
Matrix3d in_plane(const Matrix3d& form, const Vector3d& normal) {
  const Matrix3d into = Matrix3d::Identity() - normal * normal.transpose();
  return into * form * into;
}

Vector3d square_to(const Vector3d& vector, const Vector3d& direction) {
  return vector - vector.dot(direction) / direction.squaredNorm() * direction;
}

}  // namespace

Matrix3d form_from(const Vector3d& normal, const Vector3d& a, const Vector3d& b, double aa,
                   double ab, double bb) {
  const double whole = normal.dot(a.cross(b));
  const Vector3d to_a = b.cross(normal) / whole, to_b = normal.cross(a) / whole;  // dual vectors
  return aa * to_a * to_a.transpose() + ab * (to_a * to_b.transpose() + to_b * to_a.transpose()) +
         bb * to_b * to_b.transpose();
}

Frame frame_of(const PatchJet& jet) {
  const Vector3d area = jet.s.cross(jet.t);
  Frame frame;
  if (!(area.norm() > parallel_sine * jet.s.norm() * jet.t.norm())) {
    // At the point of a triangle S_s vanishes; its direction next to it does not.
    const Vector3d limit = -jet.st.cross(jet.t);
    frame.normal = limit.norm() > 0.0 ? limit.normalized() : Vector3d::Zero();
    return frame;
  }
  frame.normal = area.normalized();
  const Vector3d& n = frame.normal;
  frame.form = form_from(n, jet.s, jet.t, n.dot(jet.ss), n.dot(jet.st), n.dot(jet.tt));
  return frame;
}

Frame frame_on_edge(const Net& net, const Edge& edge, double t) {
  const model::CurveJet along = model::curve_jet(edge.curve, t);
  const model::CurveJet across = model::curve_jet(edge.across, t);
  Frame frame;
  frame.normal = along.first.cross(across.point).normalized();
  double bend_across = 0.0;
  int patches = 0;
  for (const int patch : {edge.left, edge.right}) {
    if (patch < 0 || !net.patches[patch].shape) continue;
    const PatchShape& shape = *net.patches[patch].shape;
    const Frame of_patch =
        frame_of(shape.jet(from_domain(shape.corners(), domain_place(net, edge, t))));
    bend_across += across.point.dot(of_patch.form * across.point);
    ++patches;
  }
  const Vector3d& n = frame.normal;
  frame.form = form_from(n, along.first, across.point, n.dot(along.second), n.dot(across.first),
                         patches > 0 ? bend_across / patches : 0.0);
  return frame;
}

Frame frame_with(const Frame& frame, const Vector3d& first, const Vector3d& second) {
  Frame result = frame;
  const Vector3d normal = square_to(frame.normal, first);
  if (normal.norm() > parallel_sine) result.normal = normal.normalized();
  result.form = in_plane(frame.form, result.normal);
  const double missing = result.normal.dot(second) - first.dot(result.form * first);
  const double squared = first.squaredNorm();
  result.form += missing / (squared * squared) * first * first.transpose();
  return result;
}

Frame frame_of_crossing(const Frame& old_frame, const Vector3d& first, const Vector3d& second,
                        const Vector3d& old_first, const Vector3d& old_second, double mixed) {
  Vector3d normal = first.cross(old_first);
  const double sine = normal.norm() / (first.norm() * old_first.norm());
  if (normal.dot(old_frame.normal) < 0.0) normal = -normal;
  if (sine < shallow_sine || normal.dot(old_frame.normal) < turned_cosine * normal.norm())
    return frame_with(old_frame, first, second);
  Frame frame;
  frame.normal = normal.normalized();
  frame.form = form_from(frame.normal, first, old_first, frame.normal.dot(second), mixed,
                         frame.normal.dot(old_second));
  return frame;
}

}  // namespace bodyline::strokes
