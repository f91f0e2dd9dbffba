#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace bodyline::io {

/// A dot of a picture in SVG, whose y points down, and a signed distance.
struct SvgDot {
  Eigen::Vector2d at;
  double distance = 0.0;
};

/// Dots whose colours tell their distances: grey within a quarter of the range, blue below and red
/// above, deep beyond half of it. One path per colour, of class "dots".
std::string svg_dots(const std::vector<SvgDot>& dots, double range);

}  // namespace bodyline::io
