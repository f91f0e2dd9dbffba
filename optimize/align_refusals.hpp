#pragma once

#include <Eigen/Core>

#include "optimize/align_ground.hpp"

/// What is not a car. Each throws std::invalid_argument with one sentence.
namespace bodyline::optimize {

/// Refuses a cloud that lies in its largest plane.
void refuse_flat(const Plane& plane);

/// Refuses a box, longest edge first, that no car has.
void refuse_by_box(const Eigen::Vector3d& extents);

/// What a search found out about a scan; see AlignResult.
struct FitEvidence {
  double fit = 0.0;
  double cover = 0.0;
  double doubt = 0.0;
  double length_stretch = 1.0;  ///< length over that of the start model
};

/// Whether a scan is to be taken for a car.
bool is_a_car(const FitEvidence& evidence);

/// Whether nothing less than a whole car is worth a try.
bool is_clearly_a_car(const FitEvidence& evidence);

/// Whether evidence from half of the start model is stronger than `other`.
bool is_rather_half_a_car(const FitEvidence& half, const FitEvidence& other);

/// Refuses a scan that fits a body too badly, or in two directions alike.
void refuse_by_fit(const FitEvidence& evidence);

}  // namespace bodyline::optimize
