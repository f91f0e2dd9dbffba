#pragma once

#include <vector>

#include "io/mask.hpp"
#include "model/drawing.hpp"

namespace bodyline::io {

/// The borders of a mask as closed curves (potrace), largest first, named "outline", or "hole"
/// where they lie around ground. Units are pixels: the pixel in column c of row r from the top is
/// the square from (c, -r-1) to (c+1, -r). Specks of a hundred thousandth of the picture or less
/// are left out. Throws std::invalid_argument with a sentence when nothing is left.
std::vector<model::DrawnPath> trace_mask(const Mask& mask);

}  // namespace bodyline::io
