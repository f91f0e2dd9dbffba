#include "optimize/fairness.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "model/build.hpp"
#include "model/check_fold.hpp"
#include "model/name_matches.hpp"
#include "model/selection.hpp"
#include "optimize/fairness_problem.hpp"

namespace bodyline::optimize {
namespace {

// How often a run is repeated with a stronger barrier while a face still folds. The barrier sees
// the nodes only and a face folds at its rim first, so it also starts to act at a smaller turn.
constexpr int barrier_rounds = 4;
constexpr double barrier_growth = 10.0;
constexpr double barrier_cosine_step = 0.1;

bool on_faces(const model::Term& term) {
  return term.kind != model::TermKind::closeness && term.kind != model::TermKind::fold;
}

// One barrier for every selection of faces that an objective names, and for the whole patches below
// a body's. A barrier among the terms is the user's own choice and stays the only one.
std::vector<model::Term> with_barriers(std::vector<model::Term> terms, double weight) {
  const auto is_barrier = [](const model::Term& term) {
    return term.kind == model::TermKind::fold;
  };
  if (weight <= 0.0 || std::any_of(terms.begin(), terms.end(), is_barrier)) return terms;
  std::vector<model::Term> barriers;
  const auto add = [&](model::Stage stage, const std::vector<std::string>& faces) {
    for (const model::Term& known : barriers) {
      if (known.stage == stage && (known.faces == faces || known.faces.empty())) return;
    }
    barriers.push_back({model::TermKind::fold, weight, stage, faces});
  };
  for (const model::Term& term : terms) {
    if (!on_faces(term)) continue;
    add(term.stage, term.faces);
    if (term.stage != model::Stage::base && term.faces.empty()) add(model::Stage::base, {});
  }
  terms.insert(terms.end(), barriers.begin(), barriers.end());
  return terms;
}

std::vector<int> select_variables(const model::VariableMap& map, const FairOptions& options) {
  std::vector<int> selected = map.select(options.vary);
  if (!options.hold.empty()) {
    const std::vector<int> held = map.select(options.hold);
    std::erase_if(selected, [&](int v) { return std::binary_search(held.begin(), held.end(), v); });
  }
  if (selected.empty())
    throw std::invalid_argument("every chosen variable is held; nothing is left to vary");
  return selected;
}

class Tuner {
 public:
  Tuner(const model::Model& model, const FairOptions& options)
      : model_(model),
        options_(options),
        context_(std::make_shared<model::BodyContext>(model, options.bounds)),
        selected_(select_variables(context_->map, options)),
        terms_(with_barriers(options.terms, options.fold_weight)),
        begin_(std::chrono::steady_clock::now()) {
    if (!(options.within > 0.0))
      throw std::invalid_argument("the distance that curves may move must be positive");
  }

  FairResult run();

 private:
  model::Evaluator evaluator(const std::vector<model::Term>& terms, int nodes,
                             const model::FoldOptions& fold = {}) const {
    model::EvaluatorOptions options;
    options.fold = fold;
    options.terms = terms;
    options.nodes = nodes;
    options.threads = options_.threads;
    return model::Evaluator(context_, selected_, options);
  }

  Measured measure(const Eigen::VectorXd& x) const {
    model::Evaluator fine = evaluator(terms_, options_.report_nodes);
    Measured measured;
    measured.value = fine.evaluate(x, nullptr);
    measured.terms = fine.term_values();
    return measured;
  }

  Eigen::VectorXd unfold(const Eigen::VectorXd& x, FairResult& result) const;
  Eigen::VectorXd search(const std::vector<model::Term>& terms, const Eigen::VectorXd& x,
                         FairResult& result) const;
  Eigen::VectorXd search_unfolded(Eigen::VectorXd x, FairResult& result);
  std::vector<std::string> folded_faces(const Eigen::VectorXd& x) const;

  model::Model model_at(const Eigen::VectorXd& x) const;

  model::Model model_;
  FairOptions options_;
  model::FoldOptions fold_;  // of the barrier while searching
  std::shared_ptr<model::BodyContext> context_;
  std::vector<int> selected_;
  std::vector<model::Term> terms_;
  std::chrono::steady_clock::time_point begin_;
};

Eigen::VectorXd Tuner::search(const std::vector<model::Term>& terms, const Eigen::VectorXd& x,
                              FairResult& result) const {
  model::Evaluator coarse = evaluator(terms, options_.nodes, fold_);
  FairnessProblem problem(coarse, options_.within);
  if (options_.search.algorithm == Algorithm::ceres_lm) problem.use_residuals();
  Options search = options_.search;
  // Evaluations and time run on from phase to phase.
  const int before = result.evaluations;
  const double seconds_before =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  // The time limit holds for all phases together.
  if (search.max_seconds > 0.0)
    search.max_seconds = std::max(1e-3, search.max_seconds - seconds_before);
  search.on_progress = [&, seconds_before](const Progress& progress) {
    Progress shifted = progress;
    shifted.evaluation += before;
    shifted.seconds += seconds_before;
    result.history.push_back(shifted);
    if (options_.search.on_progress) options_.search.on_progress(shifted);
  };
  const Result found = minimize(problem, x, search);
  result.status = found.status;
  result.evaluations += found.evaluations;
  result.gradient_norm = found.gradient_norm;
  return found.x;
}

// Only the barriers, which stay smooth where the energies do not.
Eigen::VectorXd Tuner::unfold(const Eigen::VectorXd& x, FairResult& result) const {
  std::vector<model::Term> barriers;
  std::copy_if(terms_.begin(), terms_.end(), std::back_inserter(barriers),
               [](const model::Term& term) { return term.kind == model::TermKind::fold; });
  if (barriers.empty()) return x;
  model::Evaluator fine = evaluator(barriers, options_.nodes);
  if (fine.evaluate(x, nullptr) == 0.0) return x;
  FairResult unreported;
  unreported.evaluations = result.evaluations;
  Tuner quiet = *this;
  quiet.options_.search.on_progress = {};
  if (is_global(quiet.options_.search.algorithm) ||
      !uses_gradient(quiet.options_.search.algorithm) ||
      quiet.options_.search.algorithm == Algorithm::ceres_lm) {
    quiet.options_.search.algorithm = Algorithm::nlopt_lbfgs;
  }
  Eigen::VectorXd unfolded = quiet.search(barriers, x, unreported);
  result.evaluations = unreported.evaluations;
  return unfolded;
}

model::Model Tuner::model_at(const Eigen::VectorXd& x) const {
  model::Model model = model_;
  Eigen::VectorXd parameters = context_->parameters;
  model::Selection(context_->map, selected_).scatter(x, parameters);
  model::set_parameters(model, context_->plan.layout, parameters);
  return model;
}

// Faces that the objective looks at, barrier or not, on which a normal turns by more than 90
// degrees against the face's mean normal.
std::vector<std::string> Tuner::folded_faces(const Eigen::VectorXd& x) const {
  std::vector<std::string> names;
  const model::Model model = model_at(x);
  for (const model::Term& term : with_barriers(options_.terms, 1.0)) {
    if (term.kind != model::TermKind::fold) continue;
    for (const model::Surface& face :
         model::build(model, term.stage, model::Halves::left_and_central)) {
      if (!model::name_is_chosen(term.faces, face.name) || !model::check_fold(face).folded)
        continue;
      names.push_back(face.name + (term.stage == model::Stage::base ? " (whole patch)" : ""));
    }
  }
  return names;
}

// A body with fewer folds is better, whatever its energies, which are singular across a fold.
bool is_worse(const FairResult& result, const std::vector<std::string>& folded_at_start) {
  if (result.folded_faces.size() != folded_at_start.size()) {
    return result.folded_faces.size() > folded_at_start.size();
  }
  if (!std::isfinite(result.start.value)) return !std::isfinite(result.end.value);
  return !(result.end.value <= result.start.value);
}

// Searches with ever stronger barriers until nothing folds; otherwise keeps the round with the
// fewest folds.
Eigen::VectorXd Tuner::search_unfolded(Eigen::VectorXd x, FairResult& result) {
  std::vector<model::Term> terms = terms_;
  Eigen::VectorXd best;
  for (int round = 0; round < barrier_rounds; ++round) {
    x = search(terms, x, result);
    const std::vector<std::string> folded = folded_faces(x);
    if (round == 0 || folded.size() < result.folded_faces.size()) {
      best = x;
      result.folded_faces = folded;
    }
    const bool stopped =
        result.status == Status::interrupted || result.status == Status::time_limit;
    if (folded.empty() || stopped || options_.fold_weight <= 0.0) break;
    for (model::Term& term : terms) {
      if (term.kind == model::TermKind::fold) term.weight *= barrier_growth;
    }
    fold_.cosine += barrier_cosine_step;
  }
  return best;
}

FairResult Tuner::run() {
  FairResult result;
  const Eigen::VectorXd given =
      model::Selection(context_->map, selected_).gather(context_->parameters);
  result.terms = terms_;
  result.start = measure(given);
  {
    model::Evaluator any = evaluator(terms_, options_.nodes);
    const FairnessProblem problem(any, options_.within);
    result.lower = problem.lower();
    result.upper = problem.upper();
  }
  const std::vector<std::string> folded_at_start = folded_faces(given);
  Eigen::VectorXd x = given.cwiseMax(result.lower).cwiseMin(result.upper);
  x = search_unfolded(unfold(x, result), result);
  result.end = measure(x);
  if (is_worse(result, folded_at_start)) {
    // The search may have started elsewhere: bounds narrower than the given model's values.
    x = given;
    result.end = result.start;
    result.folded_faces = folded_at_start;
    if (result.status != Status::interrupted && result.status != Status::failed)
      result.status = Status::no_progress;
  }
  for (int v : selected_) result.variables.push_back(context_->map.variables()[v].name);
  result.start_values = given;
  result.end_values = x;
  result.model = model_at(x);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  return result;
}

}  // namespace

FairResult fair(const model::Model& model, const FairOptions& options) {
  return Tuner(model, options).run();
}

}  // namespace bodyline::optimize
