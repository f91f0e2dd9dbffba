#include "optimize/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "model/evaluator.hpp"
#include "optimize/folded_scan.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

constexpr int cells = 6;  // of a face per direction, each seen or not
constexpr double trim = 0.9;

Distances distances_of(std::vector<double> distances) {
  Distances result;
  result.median = median(distances);
  result.p90 = quantile(distances, 0.9);
  result.p99 = quantile(distances, 0.99);
  result.trimmed_rms = trimmed_rms(std::move(distances), trim);
  return result;
}

// Which cells of a face have points near; of a face in the middle only the left half is looked at.
double share_seen(const model::Face& face, const std::vector<const Match*>& matches, double near) {
  std::array<bool, cells * cells> seen{};
  for (const Match* match : matches) {
    if (std::abs(match->distance) > near) continue;
    const int i = std::min(int(match->u * cells), cells - 1);
    const int j = std::min(int(match->v * cells), cells - 1);
    seen[i * cells + j] = true;
  }
  const bool half_u = face.central && face.central_along_u, half_v = face.central && !half_u;
  int count = 0, all = 0;
  for (int i = 0; i < (half_u ? cells / 2 : cells); ++i) {
    for (int j = 0; j < (half_v ? cells / 2 : cells); ++j, ++all) count += seen[i * cells + j];
  }
  return double(count) / all;
}

std::vector<Match> matches_of(const model::BodyContext& context, const double* nets,
                              model::Stage stage, const model::Scan& scan) {
  MatchOptions matching;
  matching.candidates = 3;
  return ScanMatcher(context.plan, stage, scan, matching).match(nets);
}

FaceDeviation face_deviation(const model::Face& face, const std::vector<const Match*>& matches,
                             double near) {
  FaceDeviation result;
  result.name = face.name;
  result.points = matches.size();
  std::vector<double> distances;
  for (const Match* match : matches) {
    distances.push_back(std::abs(match->distance));
    result.mean += match->distance / double(result.points);
  }
  result.distances = distances_of(std::move(distances));
  result.seen = share_seen(face, matches, near);
  return result;
}

}  // namespace

Deviation measure_deviation(const model::Model& model, const model::Scan& scan,
                            const model::Pose& pose, const DeviationOptions& options) {
  if (scan.points.empty()) throw std::invalid_argument("the scan has no points");
  const auto context = std::make_shared<const model::BodyContext>(model);
  model::EvaluatorOptions only_stage;
  only_stage.stage = options.stage;
  model::Evaluator evaluator(context, {}, only_stage);
  evaluator.build_parameters(context->parameters);

  Deviation result;
  result.scan = folded_scan(scan, pose, options.most_points).scan;
  result.matches = matches_of(*context, evaluator.nets(), options.stage, result.scan);
  const std::vector<model::Face>& faces = context->plan.faces(options.stage);
  std::vector<std::vector<const Match*>> of_face(faces.size());
  std::vector<double> all;
  for (const Match& match : result.matches) {
    of_face[match.face].push_back(&match);
    all.push_back(std::abs(match.distance));
  }
  result.distances = distances_of(std::move(all));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    result.faces.push_back(face_deviation(faces[f], of_face[f], options.near));
    const bool patch = faces[f].kind == model::FaceKind::patch;
    if (patch && result.faces.back().seen < options.least_seen)
      result.unseen_patches.push_back(faces[f].name);
  }
  return result;
}

}  // namespace bodyline::optimize
