#include "optimize/fit_rounds.hpp"

#include <algorithm>
#include <cmath>

#include "model/build.hpp"
#include "model/check_fold.hpp"

namespace bodyline::optimize {
namespace {

constexpr int rounds_per_search = 2;  // points change their faces only then

// From round to round of unfolding.
constexpr int settle_rounds = 6;
constexpr double fold_growth = 10.0;
constexpr double fold_cosine_step = 0.05;
constexpr double rims_decay = 0.5;  // a rim that the scan does not show well may be what folds

// Folds begin in corners, which few nodes do not see.
constexpr int nodes = 8, unfold_nodes = 32;

// Evaluations of a round: the more, the more there is to move.
constexpr int warp_evaluations = 60, curve_evaluations = 100, body_evaluations = 150;

FitRound first_round(const FitOptions& options, int nodes_per_direction) {
  FitRound round;
  round.fold_weight = options.fold;
  round.nodes = nodes_per_direction;
  round.rims = options.rims;
  round.edges = options.edges;
  return round;
}

// Scales shrink geometrically from the first round to the last.
double scale_of(double first, double last, int round, int rounds) {
  const double share = rounds > 1 ? double(round) / (rounds - 1) : 1.0;
  return first * std::pow(last / first, share);
}

std::vector<std::string> find_folded_faces(const model::Model& model) {
  std::vector<std::string> names;
  for (const model::Stage stage : {model::Stage::base, model::Stage::body}) {
    for (const model::Surface& face : model::build(model, stage, model::Halves::left_and_central)) {
      if (!model::check_fold(face).folded) continue;
      names.push_back(face.name + (stage == model::Stage::base ? " (whole patch)" : ""));
    }
  }
  return names;
}

}  // namespace

FitPhase FitRounds::phase(model::Stage stage, std::vector<std::string> vary, double bending,
                          int evaluations) const {
  FitPhaseOptions phase;
  phase.stage = stage;
  phase.detail = stage == model::Stage::body ? FitDetail::fine : FitDetail::coarse;
  phase.vary = std::move(vary);
  phase.bounds = options_->bounds;
  phase.bending = bending;
  phase.stay = options_->stay;
  phase.evaluations = evaluations;
  phase.algorithm = options_->algorithm;
  phase.should_stop = options_->should_stop;
  return FitPhase(model_, *targets_, phase);
}

bool FitRounds::usable() const { return !failed_ && std::isfinite(misfit_); }

bool FitRounds::closer_than(const FitRounds& other) const {
  return usable() != other.usable() ? usable() : usable() && misfit_ < other.misfit_;
}

void FitRounds::one_round(FitPhase& phase, const std::string& name, int index, int rounds,
                          const FitRound& round) {
  const FitPhase::Outcome outcome = phase.run(round);
  status_ = outcome.status;
  failed_ = status_ == Status::failed;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  history_.push_back({name, index + 1, rounds, outcome.distance, seconds});
  if (tells_ && options_->on_progress) options_->on_progress(history_.back());
}

void FitRounds::run(FitPhase& phase, const std::string& name, int rounds, double first,
                    double last) {
  failed_ = false;
  FitRound round = first_round(*options_, nodes);
  round.reach.normal = first;
  for (int k = 0; k < rounds && !over(); ++k) {
    round.search_anew = k % rounds_per_search == 0;
    round.reach.normal = scale_of(first, last, k, rounds);
    round.reach.rim = std::max(options_->rim_near, 2.0 * round.reach.normal);
    one_round(phase, name, k, rounds, round);
  }
  model_ = phase.model();
  misfit_ = phase.misfit(round);
}

// Keeps the round with the fewest folds.
void FitRounds::unfold(FitPhase& phase) {
  folded_faces_ = find_folded_faces(model_);
  FitRound round = first_round(*options_, unfold_nodes);
  round.reach = {options_->near, options_->rim_near};
  for (int k = 0; k < options_->unfold_rounds && !folded_faces_.empty() && !over(); ++k) {
    round.search_anew = k % rounds_per_search == 0;
    round.fold_weight *= fold_growth;
    round.fold.cosine += fold_cosine_step;
    round.rims *= rims_decay;
    round.edges *= rims_decay;
    one_round(phase, "unfold", k, options_->unfold_rounds, round);
    const model::Model model = phase.model();
    std::vector<std::string> folded = find_folded_faces(model);
    if (folded.size() >= folded_faces_.size()) continue;
    model_ = model;
    folded_faces_ = std::move(folded);
    if (folded_faces_.empty() && k > 0) settle(phase, round);
  }
}

// Back to the targets, from which strong barriers have drawn the body away, as far as nothing folds
// again.
void FitRounds::settle(FitPhase& phase, FitRound round) {
  for (int k = 0; k < settle_rounds && !over(); ++k) {
    if (k > 0 && round.fold.cosine > FitRound{}.fold.cosine) round.fold.cosine -= fold_cosine_step;
    round.search_anew = k % rounds_per_search == 0;
    one_round(phase, "settle", k, settle_rounds, round);
    const model::Model model = phase.model();
    if (!find_folded_faces(model).empty()) return;
    model_ = model;
    misfit_ = phase.misfit(round);
  }
}

void FitRounds::approach() {
  const double middle = std::sqrt(options_->far * options_->near);
  FitPhase warp = phase(model::Stage::base, {}, 0.0, warp_evaluations);
  run(warp, "warp", options_->warp_rounds, options_->far, 2.0 * middle);
  FitPhase curves = phase(model::Stage::base, {"curve.*"}, options_->bending, curve_evaluations);
  run(curves, "curves", options_->curve_rounds, 2.0 * middle, middle);
}

void FitRounds::refine() {
  FitPhase body = phase(model::Stage::body, {"*"}, options_->bending, body_evaluations);
  run(body, "body", options_->body_rounds, std::sqrt(options_->far * options_->near),
      options_->near);
  unfold(body);
}

}  // namespace bodyline::optimize
