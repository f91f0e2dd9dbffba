#include "optimize/fit_phase.hpp"

#include "model/closeness.hpp"
#include "model/selection.hpp"
#include "optimize/minimize.hpp"

namespace bodyline::optimize {

using Eigen::VectorXd;

struct FitPhase::State {
  State(const model::Model& given, const std::vector<FitTargetMaker>& makers,
        FitPhaseOptions chosen)
      : options(std::move(chosen)),
        start(given),
        context(std::make_shared<model::BodyContext>(given, options.bounds)),
        variables(*context, options.vary),
        builder(context, variables.selected(), stage_only(options.stage)),
        x(variables.start()) {
    for (const FitTargetMaker& make : makers)
      targets.push_back(make(context->plan, options.stage, options.detail));
  }

  static model::EvaluatorOptions stage_only(model::Stage stage) {
    model::EvaluatorOptions options;
    options.stage = stage;
    return options;
  }

  double first_median() const {
    for (const std::unique_ptr<FitTarget>& target : targets) {
      if (const std::optional<TargetFit> fit = target->fit()) return fit->median;
    }
    return 0.0;
  }

  FitPhaseOptions options;
  model::Model start;
  std::shared_ptr<const model::BodyContext> context;
  FitVariables variables;
  model::Evaluator builder;
  std::vector<std::unique_ptr<FitTarget>> targets;
  VectorXd x;
};

FitPhase::FitPhase(const model::Model& model, const std::vector<FitTargetMaker>& targets,
                   FitPhaseOptions options)
    : state_(std::make_unique<State>(model, targets, std::move(options))) {}
FitPhase::~FitPhase() = default;
FitPhase::FitPhase(FitPhase&&) noexcept = default;

FitPhase::Outcome FitPhase::run(const FitRound& round) {
  State& s = *state_;
  s.builder.build(s.variables.expand(s.x));
  const double* nets = s.builder.nets();
  model::EvaluatorOptions objective;
  objective.stage = s.options.stage;
  objective.fold = round.fold;
  objective.nodes = round.nodes;
  objective.terms = {{model::TermKind::bending, s.options.bending, s.options.stage, {}},
                     {model::TermKind::fold, round.fold_weight, s.options.stage, {}}};
  if (s.options.stage != model::Stage::base)
    objective.terms.push_back({model::TermKind::fold, round.fold_weight, model::Stage::base, {}});
  objective.net_terms = {
      {std::make_shared<model::Closeness>(s.context->plan, nets), s.options.stay}};
  for (const std::unique_ptr<FitTarget>& target : s.targets) {
    target->match(nets, round);
    target->advance();
    objective.net_terms.push_back(target->term());
  }
  model::Evaluator evaluator(s.context, s.variables.selected(), objective);
  FitProblem problem(evaluator, s.variables);
  Options search;
  search.algorithm = s.options.algorithm;
  if (search.algorithm == Algorithm::ceres_lm) problem.use_residuals();
  search.max_evaluations = s.options.evaluations;
  search.relative_improvement = 1e-4;  // the next round asks for something else
  search.should_stop = s.options.should_stop;
  const Result found = minimize(problem, s.x, search);
  s.x = found.x;
  return {s.first_median(), found.status};
}

double FitPhase::misfit(FitRound round) {
  State& s = *state_;
  s.builder.build(s.variables.expand(s.x));
  round.search_anew = true;
  double sum = 0.0;
  for (const std::unique_ptr<FitTarget>& target : s.targets) {
    target->match(s.builder.nets(), round);
    if (const std::optional<TargetFit> fit = target->fit()) sum += fit->misfit;
    sum += target->excess();
  }
  return sum;
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
