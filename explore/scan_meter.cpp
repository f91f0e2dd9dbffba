#include "explore/scan_meter.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/read_scan.hpp"
#include "optimize/align_scan.hpp"
#include "optimize/folded_scan.hpp"
#include "optimize/orient_normals.hpp"

namespace bodyline::explore {
namespace {

constexpr double trim = 0.9;

std::unique_ptr<const model::Scan> read_folded(const std::filesystem::path& file,
                                               const MetricSpec& metric,
                                               const model::Model& model) {
  const std::size_t points = std::size_t(metric.points);
  io::ReadScanOptions reading;
  reading.mesh_points = std::max(reading.mesh_points, points);
  const io::ScanFile scan = io::read_scan(file, reading);
  optimize::AlignOptions options;
  if (metric.posed) options.pose = model::Pose{};
  const model::Pose pose = optimize::align_scan(scan.scan, model, options).pose;
  const model::Scan outside = optimize::oriented_scan(scan.scan, pose, model, points);
  return std::make_unique<model::Scan>(optimize::folded_scan(outside, pose, points).scan);
}

optimize::MatchOptions match_options() {
  optimize::MatchOptions options;
  options.candidates = 3;
  return options;
}

}  // namespace

ScanMeter::ScanMeter(const std::filesystem::path& file, const MetricSpec& metric,
                     const model::Model& model, const model::BodyPlan& plan)
    : scan_(read_folded(file, metric, model)),
      matcher_(plan, model::Stage::body, *scan_, match_options()) {}

double ScanMeter::measure(const double* nets) const {
  std::vector<double> squared;
  // Waiting for its own tasks, a thread must not begin another variant with the same evaluator.
  tbb::this_task_arena::isolate([&] {
    for (const optimize::Match& match : matcher_.match(nets))
      squared.push_back(match.distance * match.distance);
  });
  std::sort(squared.begin(), squared.end());
  const auto kept = std::size_t(std::ceil(trim * double(squared.size())));
  double sum = 0.0;
  for (std::size_t k = 0; k < kept; ++k) sum += squared[k];
  return kept > 0 ? std::sqrt(sum / double(kept)) : NAN;
}

}  // namespace bodyline::explore
