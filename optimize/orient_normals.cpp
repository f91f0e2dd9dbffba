#include "optimize/orient_normals.hpp"

#include <algorithm>
#include <memory>

#include "model/evaluator.hpp"
#include "optimize/estimate_normals.hpp"
#include "optimize/folded_scan.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {
namespace {

constexpr int neighbours = 12;
// Of normals that agree with the start model, which is only similar; scans oriented well have 95 %.
constexpr double clear_majority = 0.85;

model::Scan thinned(const model::Scan& scan, std::size_t most_points) {
  const std::size_t count = std::min(scan.points.size(), most_points);
  model::Scan result;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = k * scan.points.size() / count;
    result.points.push_back(scan.points[at]);
    if (!scan.normals.empty()) result.normals.push_back(scan.normals[at].normalized());
  }
  return result;
}

// For each point the outward normal of the nearest face, in the scan's own coordinates; unfolded.
std::vector<Eigen::Vector3d> nearest_normals(const model::Scan& scan, const model::Pose& pose,
                                             const model::Model& start) {
  const auto context = std::make_shared<const model::BodyContext>(start);
  model::EvaluatorOptions options;
  options.stage = model::Stage::base;
  model::Evaluator evaluator(context, {}, options);
  evaluator.build_parameters(context->parameters);
  FoldedScan folded = folded_scan(scan, pose, scan.points.size());
  folded.scan.normals.clear();
  MatchOptions matching;
  matching.candidates = 1;
  const std::vector<Match> matches =
      ScanMatcher(context->plan, model::Stage::base, folded.scan, matching).match(evaluator.nets());
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    Eigen::Vector3d normal = matches[k].normal;
    if (folded.mirrored[k]) normal.y() = -normal.y();
    normals.push_back(pose.rotation.transpose() * normal);
  }
  return normals;
}

}  // namespace

model::Scan oriented_scan(const model::Scan& scan, const model::Pose& pose,
                          const model::Model& start, std::size_t most_points) {
  model::Scan result = thinned(scan, most_points);
  if (result.normals.empty()) {
    const PointTree tree(result.points);
    result.normals = estimate_normals(tree, neighbours);
  }
  const std::vector<Eigen::Vector3d> faces = nearest_normals(result, pose, start);
  std::size_t alike = 0;
  for (std::size_t k = 0; k < faces.size(); ++k) alike += faces[k].dot(result.normals[k]) > 0.0;
  const double share = double(alike) / double(std::max<std::size_t>(1, faces.size()));
  const bool all_turned = share <= 1.0 - clear_majority;
  const bool one_by_one = !all_turned && share < clear_majority;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    Eigen::Vector3d& normal = result.normals[k];
    if (!(normal.squaredNorm() > 0.5)) {
      normal = faces[k];  // the file has none here
    } else if (all_turned || (one_by_one && faces[k].dot(normal) < 0.0)) {
      normal *= -1.0;
    }
  }
  return result;
}

}  // namespace bodyline::optimize
