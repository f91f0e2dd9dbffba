#include "optimize/measure_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "model/evaluator.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {
namespace {

constexpr double held = 0.5;  // mm or degrees that count as kept

std::vector<BoundKept> measure_points(const model::BodyPlan& plan, model::Stage stage,
                                      const double* nets,
                                      const std::vector<model::HardPoint>& points) {
  if (points.empty()) return {};
  model::Scan folded;
  for (const model::HardPoint& point : points)
    folded.points.push_back({point.point.x(), -std::abs(point.point.y()), point.point.z()});
  const std::vector<Match> matches = ScanMatcher(plan, stage, folded).match(nets);
  std::vector<BoundKept> kept;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double distance = matches[k].distance;
    kept.push_back({distance, model::breach(points[k], distance) < held});
  }
  return kept;
}

}  // namespace

bool BoundsKept::all() const {
  const auto kept = [](const BoundKept& one) { return one.kept; };
  return std::all_of(dimensions.begin(), dimensions.end(), kept) &&
         std::all_of(points.begin(), points.end(), kept);
}

BoundsKept measure_bounds(const model::Model& model, const Bounds& bounds) {
  const auto context = std::make_shared<model::BodyContext>(model);
  model::EvaluatorOptions options;
  options.stage = model::Stage::body;
  model::Evaluator evaluator(context, {}, options);
  evaluator.build(Eigen::VectorXd(0));
  const model::DimensionMeter meter(model, context->plan, options.stage);
  BoundsKept result;
  for (const DimensionBound& bound : bounds.dimensions) {
    const model::Dimension dimension = model::dimension_of(model, bound.name);
    const double value = meter.measure(dimension, evaluator.nets()).value;
    result.dimensions.push_back({value, value > bound.lower - held && value < bound.upper + held});
  }
  result.points = measure_points(context->plan, options.stage, evaluator.nets(), bounds.points);
  return result;
}

}  // namespace bodyline::optimize
