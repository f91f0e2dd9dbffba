#pragma once

#include <vector>

#include "sketch/sketch_line.hpp"

namespace bodyline::sketch {

/// How well the way in which a stroke was drawn tells how fast a curve runs along it.
struct DrawnParameters {
  std::vector<double> parameters;  ///< at each point of the line, up to scale and offset
  double misfit = 0.0;             ///< of the stroke from a polynomial in them: median distance, mm
  double unevenness = 0.0;         ///< standard deviation of that polynomial's speed over its mean
};

/// The parameters of a line under which it is most nearly a polynomial of a degree. Empty when the
/// line has too few points.
DrawnParameters drawn_parameters(const SketchLine& line, int degree);

}  // namespace bodyline::sketch
