#include "optimize/estimate_normals.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d normal_of(const std::vector<Vector3d>& points,
                   const std::vector<PointTree::Neighbour>& neighbours) {
  Vector3d mean = Vector3d::Zero();
  for (const auto& near : neighbours) mean += points[near.index];
  mean /= double(neighbours.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const auto& near : neighbours) {
    const Vector3d offset = points[near.index] - mean;
    spread += offset * offset.transpose();
  }
  if (spread.trace() == 0.0) return Vector3d::Zero();
  // Scaled, since the closed form loses small spreads.
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
  solver.computeDirect(spread / spread.trace());
  return solver.eigenvectors().col(0);
}

}  // namespace

std::vector<Vector3d> estimate_normals(const PointTree& tree, int neighbours) {
  const std::vector<Vector3d>& points = tree.points();
  std::vector<Vector3d> normals(points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 512), [&](const auto& range) {
    std::vector<PointTree::Neighbour> near;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      tree.nearest(points[i], neighbours, near);
      normals[i] = normal_of(points, near);
    }
  });
  return normals;
}

}  // namespace bodyline::optimize
