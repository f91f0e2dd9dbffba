#pragma once

#include <pugixml.hpp>

#include <Eigen/Geometry>

namespace bodyline::io {

/// How the coordinates of an svg element lie in what is around it.
struct SvgViewport {
  Eigen::Affine2d to_pixels = Eigen::Affine2d::Identity();
  bool physical = false;  ///< its width or height has a unit of length, so pixels have one
};

/// From the attributes x, y, width, height, viewBox and preserveAspectRatio. Throws
/// std::invalid_argument with a sentence when they cannot be read.
SvgViewport svg_viewport(const pugi::xml_node& element);

}  // namespace bodyline::io
