#pragma once

#include <string>

#include "io/camera.hpp"
#include "model/curve_chain.hpp"

namespace bodyline::io {

/// A drawing of a chain of curves as SVG: the curves, their control polygons and where they join,
/// seen from a view in parallel projection. Sizes in pixels. Throws std::invalid_argument when a
/// curve is not valid.
std::string chain_svg(const model::CurveChain& chain, const View& view, int width, int height);

}  // namespace bodyline::io
