#include "optimize/fit_phase.hpp"

#include <algorithm>
#include <cmath>

#include "model/closeness.hpp"
#include "model/selection.hpp"
#include "optimize/minimize.hpp"
#include "optimize/quantile.hpp"
#include "optimize/scan_term.hpp"

namespace bodyline::optimize {

using Eigen::VectorXd;

struct FitPhase::State {
  State(const model::Model& given, const model::Scan& points, FitPhaseOptions chosen)
      : options(std::move(chosen)),
        start(given),
        scan(&points),
        context(std::make_shared<model::BodyContext>(given, options.bounds)),
        variables(*context, options.vary),
        matcher(context->plan, options.stage, points),
        puller(context->plan, options.stage, points),
        rims(rims_of(context->plan, options.stage)),
        term(std::make_shared<ScanTerm>(context->plan, options.stage)),
        builder(context, variables.selected(), stage_only(options.stage)),
        x(variables.start()) {}

  static model::EvaluatorOptions stage_only(model::Stage stage) {
    model::EvaluatorOptions options;
    options.stage = stage;
    return options;
  }

  FitPhaseOptions options;
  model::Model start;
  const model::Scan* scan;
  std::shared_ptr<const model::BodyContext> context;
  FitVariables variables;
  ScanMatcher matcher;
  RimPuller puller;
  std::vector<std::array<bool, 4>> rims;
  std::shared_ptr<ScanTerm> term;
  model::Evaluator builder;
  VectorXd x;
};

FitPhase::FitPhase(const model::Model& model, const model::Scan& scan, FitPhaseOptions options)
    : state_(std::make_unique<State>(model, scan, std::move(options))) {}
FitPhase::~FitPhase() = default;

FitPhase::Outcome FitPhase::run(const FitRound& round) {
  State& s = *state_;
  s.builder.build(s.variables.expand(s.x));
  const double* nets = s.builder.nets();
  std::vector<Match> matches = s.matcher.match(nets);
  std::vector<double> distances;
  for (const Match& match : matches) distances.push_back(std::abs(match.distance));

  std::vector<MatchPull> pulls = robust_pulls(matches, *s.scan, s.rims, round.reach);
  s.puller.append(nets, round.reach.rim, round.rims * double(s.scan->points.size()), matches,
                  pulls);
  s.term->set(matches, pulls);

  model::EvaluatorOptions objective;
  objective.stage = s.options.stage;
  objective.fold = round.fold;
  objective.nodes = round.nodes;
  objective.terms = {{model::TermKind::bending, s.options.bending, s.options.stage, {}},
                     {model::TermKind::fold, round.fold_weight, s.options.stage, {}}};
  if (s.options.stage != model::Stage::base)
    objective.terms.push_back({model::TermKind::fold, round.fold_weight, model::Stage::base, {}});
  objective.net_terms = {
      {s.term, 1.0}, {std::make_shared<model::Closeness>(s.context->plan, nets), s.options.stay}};
  model::Evaluator evaluator(s.context, s.variables.selected(), objective);
  FitProblem problem(evaluator, s.variables);
  Options search;
  search.max_evaluations = s.options.evaluations;
  search.relative_improvement = 1e-4;  // the next round asks for something else
  search.should_stop = s.options.should_stop;
  const Result found = minimize(problem, s.x, search);
  s.x = found.x;
  return {quantile(std::move(distances), 0.5), found.status};
}

model::Model FitPhase::model() const {
  const State& s = *state_;
  VectorXd parameters = s.context->parameters;
  model::Selection(s.context->map, s.variables.selected())
      .scatter(s.variables.expand(s.x), parameters);
  model::Model moved = s.start;
  model::set_parameters(moved, s.context->plan.layout, parameters);
  return moved;
}

}  // namespace bodyline::optimize
