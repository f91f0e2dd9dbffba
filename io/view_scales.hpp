#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/view.hpp"

namespace bodyline::io {

/// How large the car is drawn in a view.
struct DrawnSize {
  model::View view = model::View::side;
  Eigen::Vector2d size{0.0, 0.0};  ///< to the right and up in the view, in units of the drawing
  double unit_mm = 0.0;            ///< as in model::Drawing
  std::optional<double> scale;     ///< mm per unit where it is given
};

/// Length, width and height in mm, each where it is given.
using KnownSizes = std::array<std::optional<double>, 3>;

struct ViewScales {
  std::vector<double> scales;  ///< mm per unit of each view
  Eigen::Vector3d size{0.0, 0.0, 0.0};
  std::vector<std::string> notes;
};

/// Which of length, width and height a view shows to the right and up.
std::array<int, 2> shown_sizes(model::View view);

/// Finds the scales that are not given; see place_drawings.
ViewScales view_scales(std::vector<DrawnSize> views, const KnownSizes& known);

}  // namespace bodyline::io
