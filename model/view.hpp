#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace bodyline::model {

/// From where a car is drawn: side is its left side with the nose to the left of the picture, top
/// has the nose to the left as well.
enum class View { side, front, rear, top };

/// The axes of a view's picture in the coordinates of the model: right and up in the picture, and
/// from the car towards the eye. Unit vectors, right x up = toward.
struct ViewAxes {
  Eigen::Vector3d right, up, toward;
};
ViewAxes view_axes(View view);

/// Where a point of the model lies in a view's picture, mm.
Eigen::Vector2d project(View view, const Eigen::Vector3d& point);

/// "side", ...; view_of throws std::invalid_argument listing the names.
std::string view_name(View view);
View view_of(const std::string& name);
std::vector<View> all_views();

}  // namespace bodyline::model
