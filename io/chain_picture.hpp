#pragma once

#include <string>

#include "io/camera.hpp"
#include "model/curve_chain.hpp"

namespace bodyline::io {

struct ChainDrawing {
  View view;                      ///< in parallel projection
  int width = 800, height = 600;  ///< pixels
  /// Length of the teeth of curvature combs where the radius is 100 mm, in mm; no combs when 0.
  double comb_mm = 0.0;
};

/// A drawing of a chain of curves as SVG: the curves, their control polygons, where they join, and
/// if wanted curvature combs on their outer side. Throws std::invalid_argument when a curve is not
/// valid.
std::string chain_svg(const model::CurveChain& chain, const ChainDrawing& drawing);

}  // namespace bodyline::io
