#include "model/view.hpp"

#include <stdexcept>

namespace bodyline::model {

ViewAxes view_axes(View view) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  switch (view) {
    case View::front:
      return {-y, z, -x};
    case View::rear:
      return {y, z, x};
    case View::top:
      return {x, y, z};
    case View::side:
      break;
  }
  return {x, z, -y};
}

Eigen::Vector2d project(View view, const Eigen::Vector3d& point) {
  const ViewAxes axes = view_axes(view);
  return {axes.right.dot(point), axes.up.dot(point)};
}

std::string view_name(View view) {
  switch (view) {
    case View::front:
      return "front";
    case View::rear:
      return "rear";
    case View::top:
      return "top";
    case View::side:
      break;
  }
  return "side";
}

std::vector<View> all_views() { return {View::side, View::front, View::rear, View::top}; }

View view_of(const std::string& name) {
  for (const View view : all_views())
    if (view_name(view) == name) return view;
  throw std::invalid_argument("'" + name + "' is no view; there are side, front, rear and top");
}

}  // namespace bodyline::model
