#include "optimize/measure_features.hpp"

#include "model/build.hpp"
#include "optimize/feature_curve.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {

std::vector<FeatureDeviation> measure_features(const model::Model& model,
                                               const std::vector<FeatureLine>& lines) {
  const std::vector<model::Surface> patches =
      model::build(model, model::Stage::base, model::Halves::left_and_central);
  std::vector<FeatureDeviation> results;
  for (const FeatureLine& feature : lines) {
    const TiedLine line = tied_line(model, feature);
    const FeatureCurve curve(patches[line.side.patch], line.side.side);
    std::vector<double> distances;
    for (const std::vector<Eigen::Vector3d>& points : line.polylines) {
      for (const Eigen::Vector3d& point : points) {
        const FeaturePoint at = curve.nearest(point, line.seen);
        distances.push_back((line.seen * (point - at.position)).norm());
      }
    }
    results.push_back({feature.curve, median(distances), quantile(distances, 0.9)});
  }
  return results;
}

}  // namespace bodyline::optimize
