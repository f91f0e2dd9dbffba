#include "model/evaluator.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/body_builder.hpp"
#include "model/closeness.hpp"
#include "model/face_work.hpp"
#include "model/team.hpp"

namespace bodyline::model {
namespace {

constexpr double square_metre = 1e6;  // mm^2
// Every face counts twice: side faces for their mirror images, central faces because only their
// left half is summed.
constexpr double both_halves = 2.0;
constexpr int numbers_per_point = 3;

}  // namespace

BodyContext::BodyContext(const Model& model, const VariableBounds& bounds)
    : plan(plan_body(model)),
      map(model, plan.links, bounds),
      parameters(to_parameters(model, plan.layout)) {}

struct Evaluator::State {
  State(std::shared_ptr<const BodyContext> shared, std::vector<int> chosen, EvaluatorOptions given)
      : context(std::move(shared)),
        selected(std::move(chosen)),
        options(std::move(given)),
        kernel(&kernels(options.isa)),
        builder(make_body_builder(context->plan, options.isa)),
        parameters(context->parameters),
        parameters_bar(parameters.size()),
        faces(plan_face_work(context->plan, options.terms, options.nodes)),
        slots(faces.slot_count, 0.0),
        term_values(options.terms.size(), 0.0),
        net_term_values(options.net_terms.size(), 0.0),
        team(std::max(1, options.threads)),
        shares(deal_faces(faces, team.size())) {
    if (faces.has_variation) {
      variation_bar.resize(number_count());
      area_bar.resize(number_count());
    }
    stage = std::max(options.stage, faces.stage);
    for (const WeightedNetTerm& extra : options.net_terms) {
      stage = std::max(stage, extra.term->stage());
    }
    builder->build(parameters.data(), stage);
    closeness = std::make_shared<Closeness>(context->plan, nets());
  }

  int number_count() const { return numbers_per_point * context->plan.point_count; }
  double* nets() { return builder->nets(); }
  double* nets_bar() { return builder->nets_bar(); }
  void clear_adjoints();
  void pull_back(Eigen::VectorXd& gradient);
  void run_face(const FaceWork& work, bool with_gradient);
  void run_faces(bool with_gradient);
  double sum_slots(FaceWorkPlan::SlotRange range) const;
  double term_value(std::size_t index, bool with_gradient);
  double sum_terms(bool with_gradient);

  std::shared_ptr<const BodyContext> context;
  std::vector<int> selected;
  EvaluatorOptions options;
  const Kernels* kernel;
  std::unique_ptr<BodyBuilder> builder;
  Eigen::VectorXd parameters, parameters_bar;
  FaceWorkPlan faces;
  std::vector<double> slots;  // value of each term on each face
  std::vector<double> term_values, net_term_values;
  std::vector<double> variation_bar, area_bar;  // of all nets, before the factors of the product
  std::shared_ptr<Closeness> closeness;         // to the model's own nets
  Stage stage = Stage::base;
  Team team;
  std::vector<std::vector<const FaceWork*>> shares;  // of each member of the team
};

void Evaluator::State::run_face(const FaceWork& w, bool with_gradient) {
  const double* points = nets() + w.net;
  const double* blend = w.blend >= 0 ? nets() + w.blend : nullptr;
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
        slot = value(kernel->area, kernel->area_pullback, seed / square_metre, nets_bar()) /
               square_metre;
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

// Every face writes only its own slots and adjoints, so that the shares do not change the result.
void Evaluator::State::run_faces(bool with_gradient) {
  team.run([&](int member) {
    for (const FaceWork* w : shares[member]) run_face(*w, with_gradient);
  });
}

double Evaluator::State::sum_slots(FaceWorkPlan::SlotRange range) const {
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
  builder->pullback(parameters.data(), stage, parameters_bar.data());
  context->map.gather_pullback(selected, parameters_bar, gradient);
}

void Evaluator::State::clear_adjoints() {
  std::fill_n(nets_bar(), number_count(), 0.0);
  std::fill(variation_bar.begin(), variation_bar.end(), 0.0);
  std::fill(area_bar.begin(), area_bar.end(), 0.0);
}

Evaluator::Evaluator(std::shared_ptr<const BodyContext> context, std::vector<int> selected,
                     EvaluatorOptions options)
    : state_(std::make_unique<State>(std::move(context), std::move(selected), std::move(options))) {
}
Evaluator::~Evaluator() = default;
Evaluator::Evaluator(Evaluator&&) noexcept = default;
Evaluator& Evaluator::operator=(Evaluator&&) noexcept = default;

int Evaluator::size() const { return int(state_->selected.size()); }
const std::vector<int>& Evaluator::selected() const { return state_->selected; }
const BodyContext& Evaluator::context() const { return *state_->context; }
std::shared_ptr<const BodyContext> Evaluator::shared_context() const { return state_->context; }
const EvaluatorOptions& Evaluator::options() const { return state_->options; }
const std::vector<double>& Evaluator::term_values() const { return state_->term_values; }
const std::vector<double>& Evaluator::net_term_values() const { return state_->net_term_values; }
std::shared_ptr<NetTerm> Evaluator::closeness() const { return state_->closeness; }
const Eigen::VectorXd& Evaluator::parameters() const { return state_->parameters; }
const double* Evaluator::nets() const { return state_->nets(); }

Eigen::VectorXd Evaluator::start() const {
  return state_->context->map.gather(state_->selected, state_->context->parameters);
}

void Evaluator::build(const Eigen::VectorXd& x) {
  State& s = *state_;
  if (x.size() != size())
    throw std::invalid_argument("an evaluator was given a vector of the wrong size");
  s.context->map.scatter(s.selected, x, s.parameters);
  s.builder->build(s.parameters.data(), s.stage);
}

void Evaluator::build_parameters(const Eigen::VectorXd& parameters) {
  State& s = *state_;
  if (parameters.size() != s.parameters.size())
    throw std::invalid_argument("an evaluator was given parameters of the wrong size");
  s.parameters = parameters;
  s.builder->build(s.parameters.data(), s.stage);
}

double Evaluator::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  State& s = *state_;
  const bool with_gradient = gradient != nullptr;
  build(x);
  if (with_gradient) s.clear_adjoints();
  s.run_faces(with_gradient);
  const double value = s.sum_terms(with_gradient);
  if (with_gradient) {
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
