#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/variables.hpp"
#include "optimize/algorithm.hpp"
#include "optimize/fit_start.hpp"

namespace bodyline::optimize {

/// A round of a fit.
struct FitProgress {
  std::string phase;  ///< "warp", "curves", "body", "unfold" or "settle"
  int round = 0, rounds = 0;
  double distance = 0.0;  ///< median distance of the first target of points before the round, mm
  double seconds = 0.0;   ///< since the start
};

/// How a body is fitted. The defaults are meant for any car. Weights count against the
/// mean squared distance, mm^2.
struct FitOptions {
  /// All are tried, by warp and by curves; some go on (fit_body).
  std::vector<FitStart> starts = usual_fit_starts();
  int warp_rounds = 15, curve_rounds = 15, body_rounds = 20;
  int unfold_rounds = 6;    ///< most, with ever stronger barriers while a face folds
  double far = 250.0;       ///< distance off the surface that counts a quarter at first, mm,
  double near = 8.0;        ///< and at last
  double rim_near = 100.0;  ///< likewise beyond rims, at last, mm
  Algorithm algorithm = Algorithm::nlopt_lbfgs;  ///< of the search in a round
  double bending = 5e-3;                         ///< weight of the bending energy
  double fold = 1e3;                             ///< weight of the barrier against folds
  double stay = 3e-5;    ///< weight of the mean squared move of the base nets in a round
  double rims = 0.025;   ///< weight of all rims in each direction, as a share of the scan's points
  double edges = 0.025;  ///< and of all edges of the scan
  model::VariableBounds bounds;
  std::function<void(const FitProgress&)> on_progress;  ///< of one start; may be empty
  /// Polled between rounds and at evaluations, from several threads; may be empty.
  std::function<bool()> should_stop;
};

/// Throws std::invalid_argument, with the name of an option that is out of range.
void check_fit_options(const FitOptions& options);

}  // namespace bodyline::optimize
