#include "optimize/fit_car.hpp"

#include "optimize/feature_target.hpp"
#include "optimize/fit_scan.hpp"
#include "optimize/hard_point_target.hpp"
#include "optimize/outline_fit_target.hpp"
#include "optimize/outline_shift.hpp"
#include "optimize/strain_target.hpp"

namespace bodyline::optimize {

std::vector<FitTargetMaker> fit_targets(const FitCar& car, const model::Model& start,
                                        const FitWeights& weights) {
  const bool beside_scan = car.scan.has_value();
  std::vector<FitTargetMaker> targets;
  if (car.scan) targets.push_back(scan_fit_target(car.scan->scan, car.scan->pose));
  if (!car.outlines.empty()) {
    targets.push_back(outline_fit_target(
        car.outlines, beside_scan ? weights.outlines_beside_scan : weights.outlines));
  }
  if (!car.features.empty())
    targets.push_back(feature_target(start, car.features, weights.features));
  if (!car.scan || !car.outlines.empty())
    targets.push_back(strain_target(beside_scan ? weights.shape_beside_scan : weights.shape));
  if (!car.bounds.dimensions.empty())
    targets.push_back(dimension_target(start, car.bounds.dimensions));
  if (!car.bounds.points.empty()) targets.push_back(hard_point_target(car.bounds.points));
  return targets;
}

std::vector<FitStart> fit_starts(const FitCar& car) {
  return car.scan ? usual_fit_starts() : std::vector{FitStart{}};
}

Eigen::Vector3d shift_to_scan(const std::vector<model::PlacedDrawing>& drawings,
                              const PosedScan& scan, const model::Model& start) {
  FitOptions haste;
  haste.body_rounds = haste.unfold_rounds = 0;
  return outline_shift(fit_scan(scan.scan, scan.pose, start, haste).model, drawings);
}

}  // namespace bodyline::optimize
