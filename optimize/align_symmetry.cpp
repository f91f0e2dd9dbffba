#include "optimize/align_symmetry.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "optimize/geman_mcclure.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int symmetry_points = 5000;
constexpr double least_agreement = 0.7;  // of the normals of partners
// Close to the plane of symmetry every point is nearly its own image and says nothing.
constexpr double near_plane = 150.0;  // mm
const std::vector<double> scales{200, 200, 150, 100, 70, 50, 35, 25, 25, 25};

// The cloud in model axes, its tree, and steps of the plane normal . x = offset next to y = 0.
struct Mirror {
  explicit Mirror(const AlignCloud& cloud, const Placement& placement)
      : normals(cloud.normals), tree(placed(cloud, placement)), spacing(cloud.spacing) {
    for (Vector3d& normal : normals) normal = placement.rotation * normal;
  }

  static std::vector<Vector3d> placed(const AlignCloud& cloud, const Placement& placement) {
    std::vector<Vector3d> points = cloud.points;
    for (Vector3d& point : points) point = placement.rotation * point + placement.translation;
    return points;
  }

  std::vector<Vector3d> normals;
  PointTree tree;
  double spacing;
};

// The plane through a rotation about x and z and a shift along its normal.
struct MirrorPlane {
  Vector3d normal = Vector3d::UnitY();
  double offset = 0.0;
  Vector3d image(const Vector3d& point) const {
    return point - 2.0 * (normal.dot(point) - offset) * normal;
  }
  Vector3d turned(const Vector3d& direction) const {
    return direction - 2.0 * normal.dot(direction) * normal;
  }
};

struct Partner {
  double distance = 0.0;  ///< to the tangent plane of the partner
  double squared = 0.0;   ///< of the distance beyond what lies between points
  double agreement = 0.0;
  Vector3d plane;
};

Partner partner_of(const Mirror& mirror, const MirrorPlane& plane, std::size_t i) {
  const Vector3d image = plane.image(mirror.tree.points()[i]);
  const int near = mirror.tree.nearest(image).index;
  Partner partner;
  partner.plane = mirror.normals[near];
  const Vector3d offset = image - mirror.tree.points()[near];
  partner.distance = partner.plane.dot(offset);
  const double across = partner.distance * partner.distance;
  partner.squared =
      across + std::max(0.0, offset.squaredNorm() - across - 4.0 * mirror.spacing * mirror.spacing);
  partner.agreement = std::abs(partner.plane.dot(plane.turned(mirror.normals[i])));
  return partner;
}

// One Gauss-Newton step: unknowns are the normal's x and z parts and the offset.
void step(const Mirror& mirror, double scale, MirrorPlane& plane) {
  Matrix3d matrix = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  const Vector3d a = plane.normal.cross(Vector3d::UnitZ()).normalized();
  const Vector3d b = plane.normal.cross(a);
  for (std::size_t i = 0; i < mirror.normals.size(); ++i) {
    const Vector3d& point = mirror.tree.points()[i];
    const double height = plane.normal.dot(point) - plane.offset;
    if (std::abs(height) < near_plane) continue;
    const Partner partner = partner_of(mirror, plane, i);
    if (partner.agreement < least_agreement) continue;
    const double weight = geman_mcclure(partner.squared, scale);
    const double along = partner.plane.dot(plane.normal);
    const auto slope = [&](const Vector3d& turn) {
      return -2.0 * (turn.dot(point) * along + height * partner.plane.dot(turn));
    };
    const Vector3d row(slope(a), slope(b), 2.0 * along);
    matrix += weight * row * row.transpose();
    right -= weight * partner.distance * row;
  }
  for (int i = 0; i < 3; ++i) matrix(i, i) *= 1.0 + 1e-9;
  const Vector3d move = matrix.ldlt().solve(right);
  if (!move.allFinite()) return;
  plane.normal =
      (plane.normal + std::clamp(move[0], -0.2, 0.2) * a + std::clamp(move[1], -0.2, 0.2) * b)
          .normalized();
  plane.offset += move[2];
}

SymmetryResult judged(const Mirror& mirror, const MirrorPlane& plane) {
  const double reach = std::max(25.0, mirror.spacing);
  std::vector<double> distances;
  std::size_t off_plane = 0;
  for (std::size_t i = 0; i < mirror.normals.size(); ++i) {
    if (std::abs(plane.normal.dot(mirror.tree.points()[i]) - plane.offset) < near_plane) continue;
    ++off_plane;
    const Partner partner = partner_of(mirror, plane, i);
    if (partner.agreement > least_agreement && partner.squared < reach * reach)
      distances.push_back(std::abs(partner.distance));
  }
  SymmetryResult result;
  if (distances.empty()) return result;
  result.partners = double(distances.size()) / double(off_plane);
  result.residual_mm = median(std::move(distances));
  return result;
}

}  // namespace

SymmetryResult settle_symmetry(const AlignCloud& cloud, Placement& placement) {
  const Mirror mirror(thinned(cloud, symmetry_points), placement);
  MirrorPlane plane;
  for (double scale : scales) step(mirror, scale, plane);
  const Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(plane.normal, Vector3d::UnitY()).toRotationMatrix();
  // The foot of the origin on the plane stays fixed up to the shift onto y = 0.
  placement.rotation = turn * placement.rotation;
  placement.translation = turn * placement.translation;
  placement.translation.y() -= plane.offset;
  return judged(mirror, plane);
}

}  // namespace bodyline::optimize
