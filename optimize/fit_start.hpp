#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace bodyline::optimize {

/// A way to change the start body of a fit before its first round, so that one of several starts
/// lies close to any car.
struct FitStart {
  Eigen::Vector3d move = Eigen::Vector3d::Zero();  ///< of the whole body, mm
  /// How far its roof reaches to the rear: 0 as it is, a saloon's, say; 1 to the tail, with an
  /// upright rear window, as that of an estate car.
  double estate = 0.0;
};

/// Starts that are tried for any car.
std::vector<FitStart> usual_fit_starts();

/// The body from which a start sets out.
model::Model started(const model::Model& model, const FitStart& start);

}  // namespace bodyline::optimize
