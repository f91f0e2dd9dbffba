#pragma once

#include "sketch/normal_equations.hpp"

namespace bodyline::sketch {

/// What is known of one curve, as squares of errors over their deviations.
struct CurveKnowledge {
  const NormalEquations& lines;  ///< of its lines, and of further unknowns of theirs
  const NormalEquations& shape;  ///< of the template, without its speed
  const NormalEquations& speed;  ///< of the template's speed, for a tolerance of 1
  int curve_unknowns = 0;        ///< the first so many unknowns are of curves, the others of lines
};

/// By how much the speed of a curve differs from the template's, relative to its length, as the
/// lines make it most likely: the tolerance with the greatest evidence, which is the probability of
/// the lines over all curves that the tolerance allows. Where the lines do not tell how fast the
/// curve runs, or nothing can be computed, that is the least; where they contradict the template it
/// is as large as it needs.
double likely_speed_tolerance(const CurveKnowledge& knowledge);

}  // namespace bodyline::sketch
