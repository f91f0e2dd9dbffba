#include "model/surface.hpp"

#include <Eigen/Geometry>

#include "model/bernstein.hpp"
#include "model/gregory_blend.hpp"

namespace bodyline::model {
namespace {

// Below this fraction of |Su| |Sv| scale a cross product carries no direction.
constexpr double degenerate_sine = 1e-9;

// The normal's direction where Su or Sv vanishes: the vanishing one is replaced by its limit from
// inside.
Eigen::Vector3d limit_normal(const SurfaceJet& jet, double u, double v) {
  Eigen::Vector3d su = jet.d[1], sv = jet.d[2];
  const Eigen::Vector3d& suv = jet.d[4];
  if (su.norm() < sv.norm()) {
    su = v > 0.5 ? Eigen::Vector3d(-suv) : suv;
  } else {
    sv = u > 0.5 ? Eigen::Vector3d(-suv) : suv;
  }
  return su.cross(sv);
}

}  // namespace

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::base:
      return "base";
    case Stage::kept:
      return "kept";
    case Stage::body:
      return "body";
  }
  return "";
}

SurfaceJet jet(const Surface& surface, double u, double v, int order) {
  const BernsteinJet bu = bernstein(surface.degree_u, u);
  const BernsteinJet bv = bernstein(surface.degree_v, v);
  SurfaceJet result;
  for (Eigen::Vector3d& d : result.d) d.setZero();
  for (int i = 0; i <= surface.degree_u; ++i) {
    std::array<Eigen::Vector3d, 4> row{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                       Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (int j = 0; j <= surface.degree_v; ++j) {
      for (int b = 0; b <= order; ++b) row[b] += bv.d[b][j] * surface.point(i, j);
    }
    for (int a = 0; a <= order; ++a) {
      for (int b = 0; a + b <= order; ++b) result.d[jet_index(a, b)] += bu.d[a][i] * row[b];
    }
  }
  if (surface.blend) {
    const std::array<double, 10> g = blend_jet(u, v);
    for (int q = 0; q < jet_index(order, 0) + order + 1; ++q) result.d[q] += g[q] * *surface.blend;
  }
  return result;
}

Eigen::Vector3d outward_normal(const Surface& surface, double u, double v) {
  const SurfaceJet at = jet(surface, u, v, 2);
  Eigen::Vector3d normal = at.d[1].cross(at.d[2]);
  const double scale = std::max(at.d[1].squaredNorm(), at.d[2].squaredNorm());
  if (normal.norm() <= degenerate_sine * scale) normal = limit_normal(at, u, v);
  normal.normalize();
  return surface.inward ? Eigen::Vector3d(-normal) : normal;
}

Curvature curvature(const SurfaceJet& jet, bool inward) {
  const Eigen::Vector3d& su = jet.d[1];
  const Eigen::Vector3d& sv = jet.d[2];
  const Eigen::Vector3d normal = su.cross(sv);
  const double e = su.dot(su), f = su.dot(sv), g = sv.dot(sv);
  const double area = normal.norm();
  const double l = normal.dot(jet.d[3]) / area, m = normal.dot(jet.d[4]) / area,
               n = normal.dot(jet.d[5]) / area;
  const double determinant = area * area;
  Curvature result;
  // The outward normal of a sphere gives negative L, M, N; the sign makes its mean curvature
  // positive.
  result.mean = (e * n - 2.0 * f * m + g * l) / (2.0 * determinant) * (inward ? 1.0 : -1.0);
  result.gauss = (l * n - m * m) / determinant;
  return result;
}

Surface mirror_image(const Surface& surface) {
  Surface image = surface;
  image.name += ".right";
  for (Eigen::Vector3d& point : image.net) point.y() = -point.y();
  if (image.blend) image.blend->y() = -image.blend->y();
  image.inward = !surface.inward;
  return image;
}

}  // namespace bodyline::model
