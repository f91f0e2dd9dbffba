#include "model/evaluator.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <tuple>

#include "model/construction.hpp"
#include "model/face_rule.hpp"
#include "model/suggest.hpp"

namespace bodyline::model {
namespace {

constexpr double square_metre = 1e6;  // mm^2
// Every face counts twice: side faces for their mirror images, central faces because only their left half is summed.
constexpr double both_halves = 2.0;

// What is summed on one face: which terms, with which quadrature.
struct FaceWork {
  const FaceRule* rule = nullptr;
  int net = 0, blend = -1;      // offsets in points
  std::vector<int> terms;       // indices into options.terms
  std::vector<int> slots;       // where each term's value of this face goes
  int area_slot = -1;           // also sum the area, for the product in the variation term
};

Range range_of(const Face& face) {
  if (!face.central) return Range::whole;
  return face.central_along_u ? Range::half_u : Range::half_v;
}

bool on_faces(TermKind kind) { return kind != TermKind::closeness; }

}  // namespace

BodyContext::BodyContext(const Model& model, const VariableBounds& bounds)
    : plan(plan_body(model)), map(model, plan.links, bounds), parameters(to_parameters(model, plan.layout)) {}

struct Evaluator::State {
  State(std::shared_ptr<const BodyContext> shared, std::vector<int> chosen, EvaluatorOptions given)
      : context(std::move(shared)),
        selected(std::move(chosen)),
        options(std::move(given)),
        kernel(&kernels(options.isa)),
        construction(context->plan),
        parameters(context->parameters),
        parameters_bar(parameters.size()),
        start_nets(construction.nets.size()),
        term_values(options.terms.size(), 0.0),
        arena(std::max(1, options.threads)) {
    plan_work();
    construction.build(parameters.data(), stage, false);
    start_nets.assign(construction.nets.begin(), construction.nets.begin() + context->plan.kept_begin);
  }

  void plan_work();
  const FaceRule* rule_for(const Face& face);
  double* net(int offset) { return &construction.nets[offset].x; }
  double* bar(std::vector<Vec3<double>>& bars, int offset) { return &bars[offset].x; }
  void run_face(const FaceWork& work, bool with_gradient);
  void run_faces(bool with_gradient);
  double sum_terms(bool with_gradient);
  double closeness(double weight, bool with_gradient);

  std::shared_ptr<const BodyContext> context;
  std::vector<int> selected;
  EvaluatorOptions options;
  const Kernels* kernel;
  Construction<double> construction;
  Eigen::VectorXd parameters, parameters_bar;
  std::vector<Vec3<double>> start_nets;
  std::vector<double> term_values;
  Stage stage = Stage::base;
  std::map<std::tuple<int, int, Range, bool>, FaceTables> tables;
  std::vector<FaceWork> work;
  std::vector<double> slots;                          // value of each term on each face
  std::vector<std::pair<int, int>> term_slots;        // begin, end of each term
  std::pair<int, int> area_slots{0, 0};
  std::vector<std::vector<Vec3<double>>> product_bars;  // adjoints of each variation term, before its factor
  std::vector<Vec3<double>> area_bars;
  bool has_variation = false;
  tbb::task_arena arena;
};

const FaceRule* Evaluator::State::rule_for(const Face& face) {
  const auto key = std::make_tuple(face.degree_u, face.degree_v, range_of(face), face.blend >= 0);
  const auto found = tables.find(key);
  if (found != tables.end()) return &found->second.rule();
  return &tables
              .try_emplace(key, face.degree_u, face.degree_v, options.nodes, range_of(face), face.blend >= 0)
              .first->second.rule();
}

void Evaluator::State::plan_work() {
  std::map<int, FaceWork> by_net;
  int slot = 0;
  const auto work_of = [&](const Face& face) -> FaceWork& {
    FaceWork& entry = by_net[face.net];
    entry.rule = rule_for(face);
    entry.net = face.net;
    entry.blend = face.blend;
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
        const bool chosen = term.faces.empty() || std::any_of(term.faces.begin(), term.faces.end(), [&](const auto& p) {
                              return name_matches(p, face.name);
                            });
        if (!chosen) continue;
        FaceWork& entry = work_of(face);
        entry.terms.push_back(t);
        entry.slots.push_back(slot++);
      }
      if (slot == first) {
        throw std::invalid_argument("no face of stage " + std::string(stage_name(term.stage)) + " matches \"" +
                                    term.faces.front() + "\"; the nearest is \"" +
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
    product_bars.assign(1, std::vector<Vec3<double>>(construction.nets.size()));
    area_bars.resize(construction.nets.size());
  }
  slots.assign(slot, 0.0);
  for (auto& entry : by_net) work.push_back(std::move(entry.second));
}

void Evaluator::State::run_face(const FaceWork& w, bool with_gradient) {
  const double* points = net(w.net);
  const double* blend = w.blend >= 0 ? net(w.blend) : nullptr;
  const auto value = [&](Kernels::Value plain, Kernels::Pullback pullback, double seed,
                         std::vector<Vec3<double>>& bars) {
    if (!with_gradient) return plain(*w.rule, points, blend);
    return pullback(*w.rule, points, blend, seed, bar(bars, w.net), w.blend >= 0 ? bar(bars, w.blend) : nullptr);
  };
  for (std::size_t k = 0; k < w.terms.size(); ++k) {
    const Term& term = options.terms[w.terms[k]];
    const double seed = both_halves * term.weight;
    double& slot = slots[w.slots[k]];
    switch (term.kind) {
      case TermKind::bending:
        slot = value(kernel->bending, kernel->bending_pullback, seed, construction.nets_bar);
        break;
      case TermKind::variation:
        slot = value(kernel->variation, kernel->variation_pullback, both_halves, product_bars[0]);
        break;
      case TermKind::area:
        slot = value(kernel->area, kernel->area_pullback, seed / square_metre, construction.nets_bar) / square_metre;
        break;
      case TermKind::fold:
        slot = with_gradient ? kernel->fold_pullback(*w.rule, points, blend, options.fold, seed,
                                                     bar(construction.nets_bar, w.net),
                                                     w.blend >= 0 ? bar(construction.nets_bar, w.blend) : nullptr)
                             : kernel->fold(*w.rule, points, blend, options.fold);
        break;
      case TermKind::closeness:
        break;
    }
  }
  if (w.area_slot >= 0) slots[w.area_slot] = value(kernel->area, kernel->area_pullback, both_halves, area_bars);
}

void Evaluator::State::run_faces(bool with_gradient) {
  const int count = int(work.size()), threads = std::min(options.threads, count);
  if (threads <= 1) {
    for (const FaceWork& w : work) run_face(w, with_gradient);
    return;
  }
  // Interleaved shares of nearly equal cost; every face writes only its own slots and adjoints.
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, threads, 1),
        [&](const tbb::blocked_range<int>& range) {
          for (int share = range.begin(); share < range.end(); ++share) {
            for (int k = share; k < count; k += threads) run_face(work[k], with_gradient);
          }
        },
        tbb::static_partitioner());
  });
}

double Evaluator::State::closeness(double weight, bool with_gradient) {
  const int count = int(start_nets.size());
  double sum = 0.0;
  for (int k = 0; k < count; ++k) {
    const Vec3<double> move = construction.nets[k] - start_nets[k];
    sum += dot(move, move);
    if (with_gradient) construction.nets_bar[k] += scaled(2.0 * weight / count, move);
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
        for (std::size_t k = 0; k < construction.nets_bar.size(); ++k) {
          construction.nets_bar[k] +=
              scaled(term.weight * area, product_bars[0][k]) + scaled(term.weight * variation, area_bars[k]);
        }
      }
    }
    sum += term.weight * term_values[t];
  }
  return sum;
}

Evaluator::Evaluator(std::shared_ptr<const BodyContext> context, std::vector<int> selected, EvaluatorOptions options)
    : state_(std::make_unique<State>(std::move(context), std::move(selected), std::move(options))) {}
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
const double* Evaluator::nets() const { return &state_->construction.nets[0].x; }

Eigen::VectorXd Evaluator::start() const {
  return state_->context->map.gather(state_->selected, state_->context->parameters);
}

void Evaluator::build(const Eigen::VectorXd& x, bool for_pullback) {
  State& s = *state_;
  s.context->map.scatter(s.selected, x, s.parameters);
  s.construction.build(s.parameters.data(), s.stage, for_pullback);
}

double Evaluator::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  State& s = *state_;
  const bool with_gradient = gradient != nullptr;
  build(x, with_gradient);
  if (with_gradient) {
    std::fill(s.construction.nets_bar.begin(), s.construction.nets_bar.end(), Vec3<double>{});
    for (auto& bars : s.product_bars) std::fill(bars.begin(), bars.end(), Vec3<double>{});
    std::fill(s.area_bars.begin(), s.area_bars.end(), Vec3<double>{});
  }
  s.run_faces(with_gradient);
  const double value = s.sum_terms(with_gradient);
  if (with_gradient) {
    s.parameters_bar.setZero();
    s.construction.pullback(s.parameters.data(), s.stage, s.parameters_bar.data());
    s.context->map.gather_pullback(s.selected, s.parameters_bar, *gradient);
  }
  return value;
}

void Evaluator::build_pullback(const std::vector<double>& nets_bar, Eigen::VectorXd& gradient) {
  State& s = *state_;
  std::memcpy(static_cast<void*>(s.construction.nets_bar.data()), nets_bar.data(), nets_bar.size() * sizeof(double));
  s.parameters_bar.setZero();
  s.construction.pullback(s.parameters.data(), s.stage, s.parameters_bar.data());
  s.context->map.gather_pullback(s.selected, s.parameters_bar, gradient);
}

}  // namespace bodyline::model
