#include "optimize/fit_scan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "model/build.hpp"
#include "model/check_fold.hpp"
#include "optimize/fit_phase.hpp"
#include "optimize/scan_fit_target.hpp"

namespace bodyline::optimize {
namespace {

// From round to round of unfolding.
constexpr double fold_growth = 10.0;
constexpr double fold_cosine_step = 0.1;
constexpr double rims_decay = 0.5;  // a rim that the scan does not show well may be what folds

using Clock = std::chrono::steady_clock;

// Scales shrink geometrically from the first round to the last.
double scale_of(double first, double last, int round, int rounds) {
  const double share = rounds > 1 ? double(round) / (rounds - 1) : 1.0;
  return first * std::pow(last / first, share);
}

std::vector<std::string> folded_faces(const model::Model& model) {
  std::vector<std::string> names;
  for (const model::Stage stage : {model::Stage::base, model::Stage::body}) {
    for (const model::Surface& face : model::build(model, stage, model::Halves::left_and_central)) {
      if (!model::check_fold(face).folded) continue;
      names.push_back(face.name + (stage == model::Stage::base ? " (whole patch)" : ""));
    }
  }
  return names;
}

class Fitter {
 public:
  Fitter(const FitOptions& options, const model::Model& start) : options_(options) {
    result_.model = start;
  }
  FitResult run(const std::vector<FitTargetMaker>& targets);

 private:
  FitPhaseOptions phase_options(model::Stage stage, std::vector<std::string> vary, double bending,
                                int evaluations) const;
  void run_rounds(FitPhase& phase, const std::string& name, int rounds, double first, double last);
  void unfold(FitPhase& phase);
  void one_round(FitPhase& phase, const std::string& name, int index, int rounds,
                 const FitRound& round);
  bool stopped() const { return options_.should_stop && options_.should_stop(); }

  FitOptions options_;
  FitResult result_;
  Clock::time_point begin_ = Clock::now();
};

FitPhaseOptions Fitter::phase_options(model::Stage stage, std::vector<std::string> vary,
                                      double bending, int evaluations) const {
  FitPhaseOptions phase;
  phase.stage = stage;
  phase.detail = stage == model::Stage::body ? FitDetail::fine : FitDetail::coarse;
  phase.vary = std::move(vary);
  phase.bounds = options_.bounds;
  phase.bending = bending;
  phase.stay = options_.stay;
  phase.evaluations = evaluations;
  phase.should_stop = options_.should_stop;
  return phase;
}

void Fitter::one_round(FitPhase& phase, const std::string& name, int index, int rounds,
                       const FitRound& round) {
  const FitPhase::Outcome outcome = phase.run(round);
  FitProgress progress{name, index + 1, rounds, outcome.distance, 0.0};
  result_.status = outcome.status;
  progress.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  result_.history.push_back(progress);
  if (options_.on_progress) options_.on_progress(progress);
}

void Fitter::run_rounds(FitPhase& phase, const std::string& name, int rounds, double first,
                        double last) {
  for (int k = 0; k < rounds && !stopped(); ++k) {
    const double scale = scale_of(first, last, k, rounds);
    one_round(
        phase, name, k, rounds,
        {{scale, std::max(options_.rim_near, 2.0 * scale)}, options_.fold, {}, 8, options_.rims});
  }
  result_.model = phase.model();
}

// Keeps the round with the fewest folds.
void Fitter::unfold(FitPhase& phase) {
  result_.folded_faces = folded_faces(result_.model);
  FitRound round{{options_.near, options_.rim_near}, options_.fold, {}, 16, options_.rims};
  for (int k = 0; k < options_.unfold_rounds && !result_.folded_faces.empty() && !stopped(); ++k) {
    round.fold_weight *= fold_growth;
    round.fold.cosine += fold_cosine_step;
    round.rims *= rims_decay;
    one_round(phase, "unfold", k, options_.unfold_rounds, round);
    const model::Model model = phase.model();
    std::vector<std::string> folded = folded_faces(model);
    if (folded.size() >= result_.folded_faces.size()) continue;
    result_.model = model;
    result_.folded_faces = std::move(folded);
  }
}

FitResult Fitter::run(const std::vector<FitTargetMaker>& targets) {
  const double middle = std::sqrt(options_.far * options_.near);
  {
    FitPhase warp(result_.model, targets, phase_options(model::Stage::base, {}, 0.0, 60));
    run_rounds(warp, "warp", options_.warp_rounds, options_.far, 2.0 * middle);
  }
  {
    FitPhase curves(result_.model, targets,
                    phase_options(model::Stage::base, {"curve.*"}, options_.bending, 100));
    run_rounds(curves, "curves", options_.curve_rounds, 2.0 * middle, middle);
  }
  FitPhase body(result_.model, targets,
                phase_options(model::Stage::body, {"*"}, options_.bending, 150));
  run_rounds(body, "body", options_.body_rounds, middle, options_.near);
  unfold(body);
  // A round that ends at its limit is followed by the next; only the last one's limit is the fit's.
  if (stopped()) result_.status = Status::interrupted;
  result_.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  return result_;
}

}  // namespace

FitResult fit_body(const std::vector<FitTargetMaker>& targets, const model::Model& start,
                   const FitOptions& options) {
  if (!(options.far > 0.0) || !(options.near > 0.0) || !(options.rim_near > 0.0))
    throw std::invalid_argument("distances of a fit must be positive");
  return Fitter(options, start).run(targets);
}

FitResult fit_scan(const model::Scan& scan, const model::Pose& pose, const model::Model& start,
                   const FitOptions& options) {
  return fit_body({scan_fit_target(scan, pose, options.coarse_points, options.fine_points)}, start,
                  options);
}

}  // namespace bodyline::optimize
