#include "explore/metric_slopes.hpp"

#include <cmath>

#include "model/dimension.hpp"

namespace bodyline::explore {
namespace {

bool is_dimension(MetricKind kind) {
  return kind >= MetricKind::length && kind <= MetricKind::rake;
}

// A dimension of the closed body as a term of an objective.
class DimensionTerm : public model::NetTerm {
 public:
  DimensionTerm(const MetricSpec& metric, const model::Model& model, const model::BodyPlan& plan)
      : meter_(model, plan, model::Stage::body),
        dimension_(model::dimension_of(
            model, metric_name(metric.kind) +
                       (metric.kind == MetricKind::rake ? "." + metric.faces.front() : ""))) {}

  model::Stage stage() const override { return model::Stage::body; }

  double value(const double* nets, double scale, double* nets_bar) override {
    const model::DimensionValue measured = meter_.measure(dimension_, nets);
    if (nets_bar != nullptr) {
      for (const auto& [number, slope] : measured.slopes) nets_bar[number] += scale * slope;
    }
    return measured.value;
  }

  // It is no sum of squares.
  Eigen::Index residual_count() const override { return 0; }
  void residuals(const double*, Eigen::Ref<Eigen::VectorXd>, Jacobian*) override {}

 private:
  model::DimensionMeter meter_;
  model::Dimension dimension_;
};

model::EvaluatorOptions evaluator_options(const VariantPlan& plan, const MetricSpec& metric) {
  model::EvaluatorOptions options;
  options.nodes = plan.study.nodes;
  if (is_dimension(metric.kind)) {
    options.stage = model::Stage::body;
    options.net_terms.push_back(
        {std::make_shared<DimensionTerm>(metric, plan.study.models.front().model,
                                         plan.space.context()->plan),
         1.0});
  } else {
    options.terms = {term_of(metric)};
  }
  return options;
}

}  // namespace

bool has_gradient(MetricKind kind) { return is_term(kind) || is_dimension(kind); }

std::string metrics_with_gradient() {
  std::string list;
  for (const std::string& name : metric_names()) {
    if (has_gradient(metric_kind(name))) list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

MetricSlopes::MetricSlopes(std::shared_ptr<const VariantPlan> plan, const std::vector<int>& metrics)
    : plan_(std::move(plan)),
      space_(plan_->space),
      rules_(plan_->study.models.front().model, plan_->space.context()->plan),
      selection_(plan_->space.context()->map, plan_->space.body_variables()),
      columns_(std::size_t(plan_->space.column_count())),
      columns_bar_(columns_.size()),
      parameters_(plan_->space.context()->parameters) {
  for (const int metric : metrics) {
    evaluators_.emplace_back(plan_->space.context(), plan_->space.body_variables(),
                             evaluator_options(*plan_, plan_->study.metrics[metric]));
  }
}

bool MetricSlopes::evaluate(const Eigen::VectorXd& point, Eigen::VectorXd& values,
                            Eigen::MatrixXd& jacobian) {
  values.resize(count());
  jacobian.resize(count(), space_.size());
  space_.values(point, columns_);
  plan_->space.body(columns_, x_);
  selection_.scatter(x_, parameters_);
  if (rules_.check(parameters_).status != VariantStatus::valid) return false;
  x_bar_.resize(x_.size());
  slope_.resize(space_.size());
  for (int k = 0; k < count(); ++k) {
    values[k] = evaluators_[k].evaluate(x_, &x_bar_);
    plan_->space.body_pullback(columns_, x_bar_, columns_bar_);
    space_.pullback(point, columns_bar_, slope_);
    jacobian.row(k) = slope_;
  }
  return values.allFinite() && jacobian.allFinite();
}

}  // namespace bodyline::explore
