#include "optimize/body_samples.hpp"

#include <algorithm>
#include <cmath>

#include "model/build.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;
using model::Surface;

int steps_for(double length, double spacing) {
  return std::clamp(int(std::lround(length / spacing)), 1, 100);
}

double length_along(const Surface& face, bool along_u, double at) {
  double length = 0.0;
  Vector3d last;
  for (int i = 0; i <= 4; ++i) {
    const double t = i / 4.0;
    const Vector3d point = model::jet(face, along_u ? t : at, along_u ? at : t, 0).d[0];
    if (i > 0) length += (point - last).norm();
    last = point;
  }
  return length;
}

BodySamples shape_of(std::vector<Vector3d> points, std::vector<Vector3d> normals, double spacing) {
  Vector3d low = points.front(), high = points.front();
  for (const Vector3d& point : points) low = low.cwiseMin(point), high = high.cwiseMax(point);
  return {PointTree(std::move(points)), std::move(normals), low, high, spacing};
}

}  // namespace

BodySamples body_samples(const model::Model& model, double spacing) {
  std::vector<Vector3d> points, normals;
  for (const Surface& face : model::build(model, model::Stage::body)) {
    const int rows = steps_for(length_along(face, true, 0.5), spacing);
    for (int i = 0; i < rows; ++i) {
      const double u = (i + 0.5) / rows;
      const int columns = steps_for(length_along(face, false, u), spacing);
      for (int j = 0; j < columns; ++j) {
        const double v = (j + 0.5) / columns;
        points.push_back(model::jet(face, u, v, 0).d[0]);
        normals.push_back(model::outward_normal(face, u, v));
      }
    }
  }
  return shape_of(std::move(points), std::move(normals), spacing);
}

BodySamples half_of(const BodySamples& shape, double end) {
  std::vector<Vector3d> points, normals;
  for (std::size_t k = 0; k < shape.points().size(); ++k) {
    if (end * (shape.points()[k].x() - shape.centre().x()) < 0.0) continue;
    points.push_back(shape.points()[k]);
    normals.push_back(shape.normals[k]);
  }
  return shape_of(std::move(points), std::move(normals), shape.spacing);
}

}  // namespace bodyline::optimize
