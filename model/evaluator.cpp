#include "model/evaluator.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/body_builder.hpp"
#include "model/closeness.hpp"
#include "model/face_work.hpp"
#include "model/factors.hpp"
#include "model/selection.hpp"
#include "model/team.hpp"

namespace bodyline::model {
namespace {

constexpr int numbers_per_point = 3;

}  // namespace

BodyContext::BodyContext(const Model& model, const VariableBounds& bounds)
    : plan(plan_body(model)),
      map(model, plan.links, bounds),
      parameters(to_parameters(model, plan.layout)) {}

// Each member of a team builds the body for itself: numbers that another processor wrote cost more
// to fetch than to compute again.
struct Member {
  std::unique_ptr<BodyBuilder> builder;
  Eigen::VectorXd parameters;
  std::vector<const FaceWork*> faces;  // its share
};

struct Evaluator::State {
  State(std::shared_ptr<const BodyContext> shared, std::vector<int> chosen, EvaluatorOptions given);

  int number_count() const { return numbers_per_point * context->plan.point_count; }
  const double* nets() const { return members.front().builder->nets(); }
  double* nets_bar() { return members.front().builder->nets_bar(); }
  void build(const Eigen::VectorXd& x, Member& member);
  void pull_back(Eigen::VectorXd& gradient);
  void clear_adjoints(NumberRange range);
  void run_face(const FaceWork& work, const double* nets, bool with_gradient);
  void run_members(const Eigen::VectorXd& x, bool with_gradient);
  double sum_slots(NumberRange range) const;
  double term_value(std::size_t index, bool with_gradient);
  double sum_terms(bool with_gradient);

  std::shared_ptr<const BodyContext> context;
  Selection selection;
  EvaluatorOptions options;
  const Kernels* kernel;
  Eigen::VectorXd parameters_bar;
  FaceWorkPlan faces;
  std::vector<double> slots;  // value of each term on each face
  std::vector<double> term_values, net_term_values;
  std::vector<double> variation_bar, area_bar;  // of all nets, before the factors of the product
  std::shared_ptr<Closeness> closeness;         // to the model's own nets
  Stage stage = Stage::base;
  Team team;
  std::vector<Member> members;  // the first one's adjoints are everybody's
};

Evaluator::State::State(std::shared_ptr<const BodyContext> shared, std::vector<int> chosen,
                        EvaluatorOptions given)
    : context(std::move(shared)),
      selection(context->map, std::move(chosen)),
      options(std::move(given)),
      kernel(&kernels(options.isa)),
      parameters_bar(context->parameters.size()),
      faces(plan_face_work(context->plan, options.terms, options.nodes)),
      slots(faces.slot_count, 0.0),
      term_values(options.terms.size(), 0.0),
      net_term_values(options.net_terms.size(), 0.0),
      team(std::max(1, options.threads)) {
  if (faces.has_variation) {
    variation_bar.resize(number_count());
    area_bar.resize(number_count());
  }
  stage = std::max(options.stage, faces.stage);
  for (const WeightedNetTerm& extra : options.net_terms)
    stage = std::max(stage, extra.term->stage());
  for (auto& share : deal_faces(faces, team.size())) {
    members.push_back(
        {make_body_builder(context->plan, options.isa), context->parameters, std::move(share)});
    members.back().builder->build(context->parameters.data(), stage);
  }
  closeness = std::make_shared<Closeness>(context->plan, nets());
}

void Evaluator::State::build(const Eigen::VectorXd& x, Member& member) {
  selection.scatter(x, member.parameters);
  member.builder->build(member.parameters.data(), stage);
}

void Evaluator::State::run_face(const FaceWork& w, const double* nets, bool with_gradient) {
  const double* points = nets + w.net;
  const double* blend = w.blend >= 0 ? nets + w.blend : nullptr;
  const auto value = [&](Kernels::Value plain, Kernels::Pullback pullback, double seed,
                         double* bars) {
    if (!with_gradient) return plain(*w.rule, points, blend);
    return pullback(*w.rule, points, blend, seed, bars + w.net,
                    w.blend >= 0 ? bars + w.blend : nullptr);
  };
  for (std::size_t k = 0; k < w.terms.size(); ++k) {
    const Term& term = options.terms[w.terms[k]];
    const double seed = both_halves * term.weight;
    double& slot = slots[w.slots[k]];
    switch (term.kind) {
      case TermKind::bending:
        slot = value(kernel->bending, kernel->bending_pullback, seed, nets_bar());
        break;
      case TermKind::variation:
        slot =
            value(kernel->variation, kernel->variation_pullback, both_halves, variation_bar.data());
        break;
      case TermKind::area:
        slot =
            value(kernel->area, kernel->area_pullback, seed / square_mm_per_square_m, nets_bar()) /
            square_mm_per_square_m;
        break;
      case TermKind::fold:
        slot = with_gradient ? kernel->fold_pullback(*w.rule, points, blend, options.fold, seed,
                                                     nets_bar() + w.net,
                                                     w.blend >= 0 ? nets_bar() + w.blend : nullptr)
                             : kernel->fold(*w.rule, points, blend, options.fold);
        break;
      case TermKind::closeness:
        break;
    }
  }
  if (w.area_slot >= 0)
    slots[w.area_slot] = value(kernel->area, kernel->area_pullback, both_halves, area_bar.data());
}

void Evaluator::State::clear_adjoints(NumberRange range) {
  const auto clear = [&](double* bars) { std::fill(bars + range.first, bars + range.second, 0.0); };
  clear(nets_bar());
  if (!faces.has_variation) return;
  clear(variation_bar.data());
  clear(area_bar.data());
}

// Every face writes only its own slots and adjoints, so that the shares do not change the result.
void Evaluator::State::run_members(const Eigen::VectorXd& x, bool with_gradient) {
  team.run([&](int index) {
    Member& member = members[index];
    build(x, member);
    for (const FaceWork* w : member.faces) {
      if (with_gradient) {
        clear_adjoints({w->net, w->net + w->numbers});
        if (w->blend >= 0) clear_adjoints({w->blend, w->blend + numbers_per_point});
      }
      run_face(*w, member.builder->nets(), with_gradient);
    }
    if (!with_gradient || index != 0) return;
    for (const NumberRange& range : faces.between) clear_adjoints(range);
  });
}

double Evaluator::State::sum_slots(NumberRange range) const {
  double sum = 0.0;
  for (int k = range.first; k < range.second; ++k) sum += slots[k];
  return both_halves * sum;
}

double Evaluator::State::term_value(std::size_t index, bool with_gradient) {
  const Term& term = options.terms[index];
  if (term.kind == TermKind::closeness)
    return closeness->value(nets(), term.weight, with_gradient ? nets_bar() : nullptr);
  const double sum = sum_slots(faces.term_slots[index]);
  if (term.kind != TermKind::variation) return sum;
  const double area = sum_slots(faces.area_slots);
  if (with_gradient) {
    for (int k = 0; k < number_count(); ++k) {
      nets_bar()[k] += term.weight * (area * variation_bar[k] + sum * area_bar[k]);
    }
  }
  return sum * area;
}

double Evaluator::State::sum_terms(bool with_gradient) {
  double sum = 0.0;
  for (std::size_t t = 0; t < options.terms.size(); ++t) {
    term_values[t] = term_value(t, with_gradient);
    sum += options.terms[t].weight * term_values[t];
  }
  for (std::size_t t = 0; t < options.net_terms.size(); ++t) {
    const WeightedNetTerm& extra = options.net_terms[t];
    net_term_values[t] =
        extra.term->value(nets(), extra.weight, with_gradient ? nets_bar() : nullptr);
    sum += extra.weight * net_term_values[t];
  }
  return sum;
}

// From the adjoints of the nets to those of the selected variables.
void Evaluator::State::pull_back(Eigen::VectorXd& gradient) {
  parameters_bar.setZero();
  Member& first = members.front();
  first.builder->pullback(first.parameters.data(), stage, parameters_bar.data());
  selection.scatter_pullback(parameters_bar, gradient);
}

Evaluator::Evaluator(std::shared_ptr<const BodyContext> context, std::vector<int> selected,
                     EvaluatorOptions options)
    : state_(std::make_unique<State>(std::move(context), std::move(selected), std::move(options))) {
}
Evaluator::~Evaluator() = default;
Evaluator::Evaluator(Evaluator&&) noexcept = default;
Evaluator& Evaluator::operator=(Evaluator&&) noexcept = default;

int Evaluator::size() const { return state_->selection.size(); }
const std::vector<int>& Evaluator::selected() const { return state_->selection.variables(); }
const BodyContext& Evaluator::context() const { return *state_->context; }
std::shared_ptr<const BodyContext> Evaluator::shared_context() const { return state_->context; }
const EvaluatorOptions& Evaluator::options() const { return state_->options; }
const std::vector<double>& Evaluator::term_values() const { return state_->term_values; }
const std::vector<double>& Evaluator::net_term_values() const { return state_->net_term_values; }
std::shared_ptr<NetTerm> Evaluator::closeness() const { return state_->closeness; }
const Eigen::VectorXd& Evaluator::parameters() const { return state_->members.front().parameters; }
const double* Evaluator::nets() const { return state_->nets(); }

Eigen::VectorXd Evaluator::start() const {
  return state_->selection.gather(state_->context->parameters);
}

void Evaluator::require_size(const Eigen::VectorXd& x) const {
  if (x.size() != size())
    throw std::invalid_argument("an evaluator was given a vector of the wrong size");
}

void Evaluator::build(const Eigen::VectorXd& x) {
  require_size(x);
  state_->build(x, state_->members.front());
}

void Evaluator::build_parameters(const Eigen::VectorXd& parameters) {
  Member& first = state_->members.front();
  if (parameters.size() != first.parameters.size())
    throw std::invalid_argument("an evaluator was given parameters of the wrong size");
  first.parameters = parameters;
  first.builder->build(first.parameters.data(), state_->stage);
}

double Evaluator::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  require_size(x);
  State& s = *state_;
  s.run_members(x, gradient != nullptr);
  const double value = s.sum_terms(gradient != nullptr);
  if (gradient) {
    gradient->resize(size());
    s.pull_back(*gradient);
  }
  return value;
}

void Evaluator::build_pullback(const std::vector<double>& nets_bar, Eigen::VectorXd& gradient) {
  State& s = *state_;
  if (nets_bar.size() != 3 * std::size_t(s.context->plan.point_count)) {
    throw std::invalid_argument("an evaluator was given adjoints of the wrong size");
  }
  gradient.resize(size());
  std::copy(nets_bar.begin(), nets_bar.end(), s.nets_bar());
  s.pull_back(gradient);
}

}  // namespace bodyline::model
