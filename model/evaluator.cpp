#include "model/evaluator.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include "model/body_builder.hpp"
#include "model/face_rule.hpp"
#include "model/suggest.hpp"
#include "model/team.hpp"

namespace bodyline::model {
namespace {

constexpr double square_metre = 1e6;  // mm^2
// Every face counts twice: side faces for their mirror images, central faces because only their
// left half is summed.
constexpr double both_halves = 2.0;
constexpr int numbers_per_point = 3;

// What is summed on one face: which terms, with which quadrature.
struct FaceWork {
  const FaceRule* rule = nullptr;
  int net = 0, blend = -1;  // offsets in numbers
  std::vector<int> terms;   // indices into options.terms
  std::vector<int> slots;   // where each term's value of this face goes
  int area_slot = -1;       // also sum the area, for the product in the variation term
};

Range range_of(const Face& face) {
  if (!face.central) return Range::whole;
  return face.central_along_u ? Range::half_u : Range::half_v;
}

bool on_faces(TermKind kind) { return kind != TermKind::closeness; }

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
        term_values(options.terms.size(), 0.0),
        team(std::max(1, options.threads)) {
    plan_work();
    plan_shares();
    builder->build(parameters.data(), stage);
    start_nets.assign(nets(), nets() + numbers_per_point * context->plan.kept_begin);
  }

  void plan_work();
  void plan_shares();
  const FaceRule* rule_for(const Face& face);
  int number_count() const { return numbers_per_point * context->plan.point_count; }
  double* nets() { return builder->nets(); }
  double* nets_bar() { return builder->nets_bar(); }
  void clear_adjoints();
  void pull_back(Eigen::VectorXd& gradient);
  void run_face(const FaceWork& work, bool with_gradient);
  void run_faces(bool with_gradient);
  double sum_terms(bool with_gradient);
  double closeness(double weight, bool with_gradient);

  std::shared_ptr<const BodyContext> context;
  std::vector<int> selected;
  EvaluatorOptions options;
  const Kernels* kernel;
  std::unique_ptr<BodyBuilder> builder;
  Eigen::VectorXd parameters, parameters_bar;
  std::vector<double> start_nets;
  std::vector<double> term_values;
  Stage stage = Stage::base;
  std::map<std::tuple<int, int, Range, bool>, FaceTables> tables;
  std::vector<FaceWork> work;
  std::vector<double> slots;                    // value of each term on each face
  std::vector<std::pair<int, int>> term_slots;  // begin, end of each term
  std::pair<int, int> area_slots{0, 0};
  std::vector<std::vector<const FaceWork*>> shares;  // of each member of the team
  bool has_variation = false;
  std::vector<double> variation_bar, area_bar;  // of all nets, before the factors of the product
  Team team;
};

const FaceRule* Evaluator::State::rule_for(const Face& face) {
  const auto key = std::make_tuple(face.degree_u, face.degree_v, range_of(face), face.blend >= 0);
  const auto found = tables.find(key);
  if (found != tables.end()) return &found->second.rule();
  return &tables
              .try_emplace(key, face.degree_u, face.degree_v, options.nodes, range_of(face),
                           face.blend >= 0)
              .first->second.rule();
}

void Evaluator::State::plan_work() {
  std::map<int, FaceWork> by_net;
  int slot = 0;
  const auto work_of = [&](const Face& face) -> FaceWork& {
    FaceWork& entry = by_net[face.net];
    entry.rule = rule_for(face);
    entry.net = numbers_per_point * face.net;
    entry.blend = face.blend < 0 ? -1 : numbers_per_point * face.blend;
    return entry;
  };
  for (int t = 0; t < int(options.terms.size()); ++t) {
    const Term& term = options.terms[t];
    const int first = slot;
    if (on_faces(term.kind)) {
      stage = std::max(stage, term.stage);
      std::vector<std::string> names;
      for (const Face& face : context->plan.faces(term.stage)) {
        names.push_back(face.name);
        const bool chosen = term.faces.empty() ||
                            std::any_of(term.faces.begin(), term.faces.end(),
                                        [&](const auto& p) { return name_matches(p, face.name); });
        if (!chosen) continue;
        FaceWork& entry = work_of(face);
        entry.terms.push_back(t);
        entry.slots.push_back(slot++);
      }
      if (slot == first) {
        throw std::invalid_argument("no face of stage " + std::string(stage_name(term.stage)) +
                                    " matches \"" + term.faces.front() + "\"; the nearest is \"" +
                                    nearest_name(term.faces.front(), names) + "\"");
      }
    }
    term_slots.emplace_back(first, slot);
  }
  area_slots = {slot, slot};
  for (const Term& term : options.terms) {
    if (term.kind != TermKind::variation) continue;
    if (has_variation) throw std::invalid_argument("an objective can hold the variation term once");
    has_variation = true;
    for (const Face& face : context->plan.faces(term.stage)) work_of(face).area_slot = slot++;
    area_slots.second = slot;
    variation_bar.resize(number_count());
    area_bar.resize(number_count());
  }
  slots.assign(slot, 0.0);
  for (auto& entry : by_net) work.push_back(std::move(entry.second));
}

// Faces by falling cost, each to the member with the least so far.
void Evaluator::State::plan_shares() {
  std::vector<const FaceWork*> order;
  for (const FaceWork& w : work) order.push_back(&w);
  const auto cost = [](const FaceWork* w) {
    constexpr int nodes =
        40;  // the part of a face's cost that its degrees do not change, in points of a net
    return (nodes + (w->rule->degree_u + 1) * (w->rule->degree_v + 1)) *
           int(w->terms.size() + (w->area_slot >= 0));
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return cost(a) > cost(b); });
  shares.resize(team.size());
  std::vector<int> load(team.size(), 0);
  for (const FaceWork* w : order) {
    const auto least = std::min_element(load.begin(), load.end()) - load.begin();
    shares[least].push_back(w);
    load[least] += cost(w);
  }
}

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

double Evaluator::State::closeness(double weight, bool with_gradient) {
  const double count = double(context->plan.kept_begin);
  double sum = 0.0;
  for (std::size_t k = 0; k < start_nets.size(); ++k) {
    const double move = nets()[k] - start_nets[k];
    sum += move * move;
    if (with_gradient) nets_bar()[k] += 2.0 * weight / count * move;
  }
  return sum / count;
}

double Evaluator::State::sum_terms(bool with_gradient) {
  const auto total = [&](std::pair<int, int> range) {
    double sum = 0.0;
    for (int k = range.first; k < range.second; ++k) sum += slots[k];
    return both_halves * sum;
  };
  double sum = 0.0;
  for (std::size_t t = 0; t < options.terms.size(); ++t) {
    const Term& term = options.terms[t];
    if (term.kind == TermKind::closeness) {
      term_values[t] = closeness(term.weight, with_gradient);
    } else {
      term_values[t] = total(term_slots[t]);
    }
    if (term.kind == TermKind::variation) {
      const double area = total(area_slots), variation = term_values[t];
      term_values[t] = variation * area;
      if (with_gradient) {
        for (int k = 0; k < number_count(); ++k) {
          nets_bar()[k] += term.weight * (area * variation_bar[k] + variation * area_bar[k]);
        }
      }
    }
    sum += term.weight * term_values[t];
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
