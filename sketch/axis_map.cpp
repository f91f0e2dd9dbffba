#include "sketch/axis_map.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "sketch/curve_jet.hpp"

namespace bodyline::sketch {
namespace {

constexpr double no_extent = 1.0;  // mm

// The box of a curve on the left half, where all lines are drawn.
Eigen::AlignedBox3d left_box(const model::Curve& curve) {
  Eigen::AlignedBox3d box;
  constexpr int count = 65;
  for (int k = 0; k < count; ++k) {
    Eigen::Vector3d point = curve_jet<3>(curve.points, double(k) / (count - 1)).point;
    point.y() = -std::abs(point.y());
    box.extend(point);
  }
  return box;
}

}  // namespace

AxisMap map_of_boxes(const model::Model& model, std::span<const SketchLine> lines) {
  std::array<Eigen::AlignedBox1d, 3> drawn, given;
  for (const SketchLine& line : lines) {
    const Eigen::AlignedBox3d box = left_box(model.curves[line.curve]);
    const model::ViewAxes axes = model::view_axes(line.view);
    for (int axis = 0; axis < 3; ++axis) {
      const double right = axes.right[axis], up = axes.up[axis];
      if (right == 0.0 && up == 0.0) continue;
      for (const Eigen::Vector2d& point : line.points) {
        const double at = right * point.x() + up * point.y();
        drawn[axis].extend(Eigen::Vector<double, 1>(axis == 1 ? -std::abs(at) : at));
      }
      given[axis].extend(Eigen::Vector<double, 1>(box.min()[axis]));
      given[axis].extend(Eigen::Vector<double, 1>(box.max()[axis]));
    }
  }
  AxisMap map;
  for (const int axis : {0, 2}) {
    if (drawn[axis].isEmpty()) continue;
    const double from = given[axis].sizes()[0], to = drawn[axis].sizes()[0];
    if (from > no_extent && to > no_extent) map.scale[axis] = to / from;
    map.shift[axis] = drawn[axis].center()[0] - map.scale[axis] * given[axis].center()[0];
  }
  if (!drawn[1].isEmpty() && -given[1].min()[0] > no_extent)
    map.scale.y() = drawn[1].min()[0] / given[1].min()[0];
  return map;
}

AxisMap map_of_points(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& pairs,
                      const AxisMap& otherwise) {
  AxisMap map = otherwise;
  if (pairs.empty()) return map;
  Eigen::Vector3d from_mean(0, 0, 0), to_mean(0, 0, 0);
  for (const auto& [from, to] : pairs) from_mean += from, to_mean += to;
  from_mean /= double(pairs.size());
  to_mean /= double(pairs.size());
  from_mean.y() = to_mean.y() = 0.0;  // the plane of symmetry stays where it is
  Eigen::Vector3d products(0, 0, 0), squares(0, 0, 0);
  for (const auto& [from, to] : pairs) {
    products += (from - from_mean).cwiseProduct(to - to_mean);
    squares += (from - from_mean).cwiseAbs2();
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (squares[axis] > no_extent * no_extent * double(pairs.size()))
      map.scale[axis] = products[axis] / squares[axis];
    if (axis != 1) map.shift[axis] = to_mean[axis] - map.scale[axis] * from_mean[axis];
  }
  return map;
}

}  // namespace bodyline::sketch
