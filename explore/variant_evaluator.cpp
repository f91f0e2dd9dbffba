#include "explore/variant_evaluator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "explore/arch_meter.hpp"
#include "explore/body_rules.hpp"
#include "explore/box_meter.hpp"
#include "explore/edge_meter.hpp"
#include "explore/face_meter.hpp"
#include "explore/frontal_meter.hpp"
#include "model/bernstein.hpp"
#include "model/selection.hpp"

namespace bodyline::explore {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double degrees = 180.0 / std::numbers::pi;

bool has_any(const Study& study, std::initializer_list<MetricKind> kinds) {
  return std::any_of(study.metrics.begin(), study.metrics.end(), [&](const MetricSpec& metric) {
    return std::find(kinds.begin(), kinds.end(), metric.kind) != kinds.end();
  });
}

// The point of an end of a face in its middle: u = 0 or 1, v = 1/2.
Eigen::Vector3d middle_of_end(const model::Face& face, const double* nets, bool last) {
  const double* row = nets + 3 * (face.net + (last ? face.degree_u * (face.degree_v + 1) : 0));
  const model::BernsteinJet basis = model::bernstein(face.degree_v, 0.5);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int j = 0; j <= face.degree_v; ++j)
    sum += basis.d[0][j] * Eigen::Map<const Eigen::Vector3d>(row + 3 * j);
  return sum;
}

// The angle from the vertical of the chord between the ends, in degrees.
double rake(const model::Face& face, const double* nets) {
  const Eigen::Vector3d chord = middle_of_end(face, nets, true) - middle_of_end(face, nets, false);
  return degrees * std::atan2(std::abs(chord.x()), std::abs(chord.z()));
}

// All parameters that follow a variable that moves.
std::vector<int> moving_parameters(const DesignSpace& space) {
  std::vector<int> parameters;
  for (const int variable : space.body_variables()) {
    for (const model::Tie& tie : space.context()->map.variables()[variable].ties)
      parameters.push_back(tie.parameter);
  }
  return parameters;
}

// The stage that the metrics need; dimensions are those of the closed body.
model::EvaluatorOptions evaluator_options(const Study& study) {
  model::EvaluatorOptions options;
  options.terms = metric_terms(study).together;
  options.stage = model::Stage::body;
  options.nodes = study.nodes;
  return options;
}

std::vector<model::Evaluator> evaluators_apart(const VariantPlan& plan) {
  std::vector<model::Evaluator> evaluators;
  for (const model::Term& term : metric_terms(plan.study).apart) {
    model::EvaluatorOptions options;
    options.terms = {term};
    options.nodes = plan.study.nodes;
    evaluators.emplace_back(plan.space.context(), plan.space.body_variables(), options);
  }
  return evaluators;
}

// How many terms were taken of those that are measured together, and of those apart.
struct TermCount {
  std::size_t together = 0, apart = 0;
  bool has_variation = false;
};

}  // namespace

struct VariantEvaluator::State {
  explicit State(std::shared_ptr<const VariantPlan> of);

  VariantOutcome measure(std::span<const double> values, std::span<double> metrics);
  void measure_parts();
  double term(MetricKind kind, TermCount& count) const;
  double metric(std::size_t index, TermCount& count) const;
  VariantOutcome judge(std::span<const double> metrics) const;

  std::shared_ptr<const VariantPlan> plan;
  const model::BodyPlan& body;
  model::Evaluator evaluator;
  std::vector<model::Evaluator> apart;  // of one term each
  model::Selection selection;
  Eigen::VectorXd x, parameters;
  BodyRules rules;
  std::optional<BoxMeter> box_meter;
  std::optional<ArchMeter> arch_meters[2];
  std::optional<FoldMeter> fold_meter;
  std::optional<VolumeMeter> volume_meter;
  std::optional<FrontalMeter> frontal_meter;
  std::optional<EdgeMeter> edge_meter;
  // Of the variant in hand, where a metric needs it.
  BodyReach reach;
  double arches[2] = {0.0, 0.0};  // x of both centres
  bool arches_move[2] = {false, false};
  double volume = 0.0, frontal_area = 0.0;
  bool count_folds = false;
  int folds = 0, first_fold = -1;
  EdgeMeter::Worst edges;
};

VariantEvaluator::State::State(std::shared_ptr<const VariantPlan> of)
    : plan(std::move(of)),
      body(plan->space.context()->plan),
      evaluator(plan->space.context(), plan->space.body_variables(),
                evaluator_options(plan->study)),
      apart(evaluators_apart(*plan)),
      selection(plan->space.context()->map, plan->space.body_variables()),
      parameters(plan->space.context()->parameters),
      rules(plan->study.models.front().model, body) {
  using enum MetricKind;
  const Study& study = plan->study;
  const model::Model& model = study.models.front().model;
  if (has_any(study, {length, width, height, front_overhang, rear_overhang, frontal_area}))
    box_meter.emplace(body);
  if (has_any(study, {wheelbase, front_overhang, rear_overhang})) {
    const std::vector<int> moving = moving_parameters(plan->space);
    for (int end = 0; end < 2; ++end) {
      arch_meters[end].emplace(model, body.layout, end == 0 ? model.front_arch : model.rear_arch);
      arches[end] = arch_meters[end]->measure(parameters).x;
      arches_move[end] = arch_meters[end]->moves_with(moving);
    }
  }
  count_folds = has_any(study, {MetricKind::folds});
  if (study.checks.folds || count_folds) fold_meter.emplace(body);
  if (has_any(study, {MetricKind::volume})) volume_meter.emplace(body);
  if (has_any(study, {MetricKind::frontal_area})) frontal_meter.emplace(body);
  if (has_any(study, {kink, gap})) edge_meter.emplace(model, body);
}

void VariantEvaluator::State::measure_parts() {
  const double* const nets = evaluator.nets();
  if (box_meter) reach = box_meter->measure(nets);
  for (int end = 0; end < 2; ++end) {
    if (arches_move[end]) arches[end] = arch_meters[end]->measure(parameters).x;
  }
  if (fold_meter) folds = fold_meter->measure(nets, !count_folds, first_fold);
  if (volume_meter) volume = volume_meter->measure(nets);
  if (frontal_meter) frontal_area = frontal_meter->measure(nets, reach);
  if (edge_meter) edges = edge_meter->measure(nets);
}

// The next term of the objective among the metrics.
double VariantEvaluator::State::term(MetricKind kind, TermCount& count) const {
  if (kind == MetricKind::variation && count.has_variation)
    return apart[count.apart++].term_values().front();
  count.has_variation |= kind == MetricKind::variation;
  return evaluator.term_values()[count.together++];
}

double VariantEvaluator::State::metric(std::size_t index, TermCount& count) const {
  const MetricSpec& spec = plan->study.metrics[index];
  if (is_term(spec.kind)) return term(spec.kind, count);
  switch (spec.kind) {
    case MetricKind::length:
      return reach.length();
    case MetricKind::width:
      return reach.width();
    case MetricKind::height:
      return reach.height();
    case MetricKind::wheelbase:
      return arches[1] - arches[0];
    case MetricKind::front_overhang:
      return arches[0] - reach.front;
    case MetricKind::rear_overhang:
      return reach.rear - arches[1];
    case MetricKind::rake:
      for (const model::Face& face : body.base_faces) {
        if (face.name == spec.faces.front()) return rake(face, evaluator.nets());
      }
      return nan;
    case MetricKind::frontal_area:
      return frontal_area;
    case MetricKind::volume:
      return volume;
    case MetricKind::folds:
      return folds;
    case MetricKind::kink:
      return edges.kink_deg;
    case MetricKind::gap:
      return edges.gap_mm;
    case MetricKind::scan:
      return plan->scans[index]->measure(evaluator.nets());
    case MetricKind::outline:
      return plan->outlines[index]->measure(evaluator.nets());
    default:
      return nan;
  }
}

VariantOutcome VariantEvaluator::State::judge(std::span<const double> metrics) const {
  const std::size_t first_metric = 1 + body.body_faces.size();
  for (std::size_t k = 0; k < metrics.size(); ++k) {
    if (!std::isfinite(metrics[k])) return {VariantStatus::not_finite, Cause(first_metric + k)};
  }
  if (plan->study.checks.folds && folds > 0) return {VariantStatus::folded, Cause(1 + first_fold)};
  for (const Constraint& constraint : plan->study.constraints) {
    for (std::size_t k = 0; k < metrics.size(); ++k) {
      if (plan->study.metrics[k].name != constraint.metric) continue;
      if (metrics[k] < constraint.least || metrics[k] > constraint.most)
        return {VariantStatus::infeasible, Cause(first_metric + k)};
    }
  }
  return {};
}

VariantOutcome VariantEvaluator::State::measure(std::span<const double> values,
                                                std::span<double> metrics) {
  std::fill(metrics.begin(), metrics.end(), nan);
  plan->space.body(values, x);
  selection.scatter(x, parameters);
  if (const VariantOutcome broken = rules.check(parameters); broken.status != VariantStatus::valid)
    return broken;
  evaluator.evaluate(x, nullptr);
  for (model::Evaluator& one : apart) one.evaluate(x, nullptr);
  measure_parts();
  TermCount count;
  for (std::size_t k = 0; k < metrics.size(); ++k) metrics[k] = metric(k, count);
  return judge(metrics);
}

VariantEvaluator::VariantEvaluator(std::shared_ptr<const VariantPlan> plan)
    : state_(std::make_unique<State>(std::move(plan))) {}
VariantEvaluator::~VariantEvaluator() = default;
VariantEvaluator::VariantEvaluator(VariantEvaluator&&) noexcept = default;

const VariantPlan& VariantEvaluator::plan() const { return *state_->plan; }

VariantOutcome VariantEvaluator::measure(std::span<const double> values,
                                         std::span<double> metrics) {
  return state_->measure(values, metrics);
}

std::span<const double> VariantEvaluator::nets() const {
  return {state_->evaluator.nets(), 3 * std::size_t(state_->body.point_count)};
}

}  // namespace bodyline::explore
