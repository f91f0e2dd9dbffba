#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "optimize/constrained_search.hpp"

namespace bodyline::explore {

/// A point whose two objectives cannot both be made smaller nearby.
struct FrontPoint {
  Eigen::VectorXd x;             ///< in the unit cube
  std::array<double, 2> values;  ///< of the objectives, both to be small
  bool usable = true;            ///< measured, and no constraint broken
};

/// A point of the front to be found: where the search starts, and what it aims at.
struct FrontTask {
  Eigen::VectorXd start;
  std::vector<optimize::Aim> aims;
};

/// Finds the points of a round of tasks, which do not depend on each other, in their order. Fewer
/// points than tasks end the tracing.
using FindPoints = std::function<std::vector<FrontPoint>(const std::vector<FrontTask>&)>;

/// Traces the front of two objectives from end to end, at most `points` points of it. The first
/// two make one objective each as small as it gets, from `start`. Every further round bisects the
/// widest gaps between neighbours, in units of the ends' difference: it aims from the middle of the
/// chord to both objectives, in units of the gap (the scalarization of Pascoletti and Serafini),
/// starting from between the neighbours. A gap that a point does not part is left alone: there the
/// front is broken. What is asked for depends only on the points found before.
std::vector<FrontPoint> trace_front(const Eigen::VectorXd& start, int points,
                                    const FindPoints& find);

}  // namespace bodyline::explore
