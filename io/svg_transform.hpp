#pragma once

#include <Eigen/Geometry>
#include <string_view>

namespace bodyline::io {

/// The attribute transform of an SVG element: matrix, translate, scale, rotate, skewX and skewY in
/// any number. Throws std::invalid_argument with a sentence when it cannot be read.
Eigen::Affine2d svg_transform(std::string_view text);

}  // namespace bodyline::io
