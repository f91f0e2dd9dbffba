#pragma once

#include <optional>
#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"
#include "model/scan.hpp"
#include "optimize/feature_line.hpp"
#include "optimize/fit_start.hpp"
#include "optimize/fit_target.hpp"
#include "optimize/measure_bounds.hpp"

/// What `bodyline fit` fits a body to: with fit_body, all of it in a few calls.
namespace bodyline::optimize {

/// A scan with outward normals, and where it lies.
struct PosedScan {
  model::Scan scan;
  model::Pose pose;
};

/// What is known of a car; drawings, lines and bounds in the coordinates of the model, mm.
struct FitCar {
  std::optional<PosedScan> scan;
  std::vector<model::PlacedDrawing> outlines;
  std::vector<FeatureLine> features;
  Bounds bounds;
};

/// How targets count against each other: against mean squared distances, mm^2.
struct FitWeights {
  double outlines = 1.0;
  double outlines_beside_scan = 0.3;  ///< they show less of the car than the scan does
  double features = 1.0;
  double shape = 100.0;  ///< of the strain, which holds what outlines and lines do not show
  double shape_beside_scan = 1.0;
};

/// The targets of a fit of `start`; the scan is the first. Throws std::invalid_argument as the
/// makers of targets do.
std::vector<FitTargetMaker> fit_targets(const FitCar& car, const model::Model& start,
                                        const FitWeights& weights = {});

/// The starts to try: the usual ones with a scan; without one the body as it is, since outlines say
/// nothing of where curves lie on the surface, and the start decides that.
std::vector<FitStart> fit_starts(const FitCar& car);

/// The move of drawings, mm, to where a body lies that is fitted to the scan in haste
/// (outline_shift).
Eigen::Vector3d shift_to_scan(const std::vector<model::PlacedDrawing>& drawings,
                              const PosedScan& scan, const model::Model& start);

}  // namespace bodyline::optimize
