#include "optimize/fit_scan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "model/closeness.hpp"
#include "model/selection.hpp"
#include "optimize/fit_variables.hpp"
#include "optimize/folded_scan.hpp"
#include "optimize/minimize.hpp"
#include "optimize/rim_pulls.hpp"
#include "optimize/robust_pulls.hpp"
#include "optimize/scan_match.hpp"
#include "optimize/scan_term.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

// One phase of a fit: what moves, at which stage, and how the scale of outliers shrinks.
struct Phase {
  const char* name;
  model::Stage stage;
  std::vector<std::string> vary;
  int rounds = 0;
  double first_scale = 0.0, last_scale = 0.0;  // mm
  double bending = 0.0, stay = 0.0;            // weights
  int evaluations = 0;                         // most of a round
};

class Fitter {
 public:
  Fitter(const model::Scan& scan, const model::Pose& pose, const model::Model& start,
         const FitOptions& options)
      : scan_(&scan), pose_(&pose), options_(options) {
    result_.model = start;
  }

  FitResult run();

 private:
  void warp(const model::Scan& scan);
  void run_phase(const Phase& phase, const model::Scan& scan);
  void report(const Phase& phase, int round, double distance);
  bool stopped() const { return options_.should_stop && options_.should_stop(); }

  const model::Scan* scan_;
  const model::Pose* pose_;
  FitOptions options_;
  FitResult result_;
};

double scale_of_round(const Phase& phase, int round) {
  const double share = phase.rounds > 1 ? double(round) / (phase.rounds - 1) : 1.0;
  return phase.first_scale * std::pow(phase.last_scale / phase.first_scale, share);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_distance(const std::vector<Match>& matches) {
  std::vector<double> distances;
  for (const Match& one : matches) distances.push_back(std::abs(one.distance));
  return median(std::move(distances));
}

void Fitter::report(const Phase& phase, int round, double distance) {
  result_.history.push_back({phase.name, round + 1, phase.rounds, distance});
  if (options_.on_progress) options_.on_progress(result_.history.back());
}

void Fitter::run_phase(const Phase& phase, const model::Scan& scan) {
  const auto context = std::make_shared<model::BodyContext>(result_.model, options_.bounds);
  const FitVariables variables(*context, phase.vary, phase.stage);
  const auto term = std::make_shared<ScanTerm>(context->plan, phase.stage);
  model::EvaluatorOptions options;
  options.terms = {{model::TermKind::bending, phase.bending, phase.stage, {}},
                   {model::TermKind::fold, options_.fold, phase.stage, {}}};
  options.net_terms = {{term, 1.0}, {nullptr, phase.stay}};
  MatchOptions matching;
  const ScanMatcher matcher(context->plan, phase.stage, scan, matching);
  const RimPuller puller(context->plan, phase.stage, scan);
  const auto rims = rims_of(context->plan, phase.stage);
  VectorXd x = variables.start();
  std::vector<double> nets(3 * std::size_t(context->plan.point_count));
  model::EvaluatorOptions plain;
  plain.stage = phase.stage;
  model::Evaluator builder(context, variables.selected(), plain);
  for (int round = 0; round < phase.rounds && !stopped(); ++round) {
    builder.build(variables.expand(x));
    std::copy(builder.nets(), builder.nets() + nets.size(), nets.begin());
    std::vector<Match> matches = matcher.match(nets.data());
    report(phase, round, median_distance(matches));
    const PullReach reach{scale_of_round(phase, round),
                          std::max(options_.least_rim_reach, 2.0 * scale_of_round(phase, round))};
    std::vector<MatchPull> pulls = robust_pulls(matches, scan, rims, reach);
    puller.append(nets.data(), reach.rim, options_.rims * double(scan.points.size()), matches,
                  pulls);
    term->set(matches, pulls);
    options.net_terms[1].term = std::make_shared<model::Closeness>(context->plan, nets.data());
    model::Evaluator evaluator(context, variables.selected(), options);
    FitProblem problem(evaluator, variables);
    Options search;
    search.max_evaluations = phase.evaluations;
    search.relative_improvement = 1e-4;
    search.should_stop = options_.should_stop;
    const Result found = minimize(problem, x, search);
    x = found.x;
  }
  VectorXd parameters = context->parameters;
  model::Selection(context->map, variables.selected()).scatter(variables.expand(x), parameters);
  model::set_parameters(result_.model, context->plan.layout, parameters);
}

FitResult Fitter::run() {
  const auto begin = std::chrono::steady_clock::now();
  const model::Scan coarse = folded_scan(*scan_, *pose_, options_.coarse_points);
  const model::Scan fine = folded_scan(*scan_, *pose_, options_.fine_points);
  const double middle = std::sqrt(options_.far * options_.near);
  run_phase({"warp",
             model::Stage::base,
             {},
             options_.warp_rounds,
             options_.far,
             middle * 2,
             0.0,
             options_.stay,
             60},
            coarse);
  run_phase({"curves",
             model::Stage::base,
             {"curve.*"},
             options_.curve_rounds,
             middle * 2,
             middle,
             options_.bending,
             options_.stay,
             100},
            coarse);
  run_phase({"body",
             model::Stage::body,
             {"curve.*", "shape.*", "cut.*", "fullness.*", "lean.*"},
             options_.body_rounds,
             middle,
             options_.near,
             options_.bending,
             options_.stay,
             150},
            fine);
  result_.status = stopped() ? Status::interrupted : Status::small_improvement;
  result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result_;
}

}  // namespace

FitResult fit_scan(const model::Scan& scan, const model::Pose& pose, const model::Model& start,
                   const FitOptions& options) {
  return Fitter(scan, pose, start, options).run();
}

}  // namespace bodyline::optimize
