#include "explore/tuned_source.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "explore/goal_functions.hpp"
#include "explore/variant_evaluator.hpp"
#include "optimize/constrained_search.hpp"
#include "optimize/minimize.hpp"

namespace bodyline::explore {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double tolerance = 1e-7;    // of the sum at the start
constexpr double typical_move = 0.3;  // of a range

// The sum of goals as a problem without constraints.
class SumProblem : public optimize::Problem {
 public:
  SumProblem(GoalFunctions& functions, const Eigen::VectorXd& start)
      : functions_(functions),
        lower_(Eigen::VectorXd::Zero(start.size())),
        upper_(Eigen::VectorXd::Ones(start.size())),
        scale_(Eigen::VectorXd::Constant(start.size(), typical_move)) {}

  Eigen::Index size() const override { return lower_.size(); }
  const Eigen::VectorXd& lower() const override { return lower_; }
  const Eigen::VectorXd& upper() const override { return upper_; }
  const Eigen::VectorXd& scale() const override { return scale_; }

  double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) override {
    if (!functions_.evaluate(x, values_, jacobian_)) return nan;
    if (gradient != nullptr) *gradient = jacobian_.row(0);
    return values_[0];
  }

 private:
  GoalFunctions& functions_;
  Eigen::VectorXd lower_, upper_, scale_, values_;
  Eigen::MatrixXd jacobian_;
};

// Less is better.
using Rank = std::tuple<int, double, double>;

class Worker {
 public:
  explicit Worker(std::shared_ptr<const VariantPlan> plan)
      : plan_(std::move(plan)),
        functions_(plan_, GoalFunctions::Goals::summed),
        evaluator_(plan_),
        metrics_(plan_->study.metrics.size()) {}

  // From a row of start values to one of tuned values.
  void tune(std::span<double> values) {
    const std::vector<double> found = functions_.space().rounded(search(values));
    if (rank(found) <= rank(values)) std::copy(found.begin(), found.end(), values.begin());
  }

 private:
  Eigen::VectorXd search(std::span<const double> values) {
    const OptimizerSpec& spec = *plan_->study.optimizer;
    const Eigen::VectorXd start = functions_.space().point(values);
    if (plan_->study.constraints.empty()) {
      SumProblem problem(functions_, start);
      optimize::Options options;
      options.algorithm = spec.algorithm;
      options.max_evaluations = spec.evaluations;
      return optimize::minimize(problem, start, options).x;
    }
    optimize::ConstrainedSearch search;
    search.aims = {{}};
    search.tolerance = tolerance;
    search.first_constraint = 1;
    search.algorithm = spec.algorithm;
    search.max_evaluations = spec.evaluations;
    return optimize::search_constrained(functions_, start, search).x;
  }

  Rank rank(std::span<const double> values) {
    const VariantStatus status = evaluator_.measure(values, metrics_).status;
    if (int(status) > int(VariantStatus::folded)) return {int(VariantStatus::cut_order), 0.0, 0.0};
    const std::vector<double> goals = goal_values(plan_->study, metrics_);
    return {int(status), broken_constraints(plan_->study, metrics_),
            std::accumulate(goals.begin(), goals.end(), 0.0)};
  }

  std::shared_ptr<const VariantPlan> plan_;
  GoalFunctions functions_;
  VariantEvaluator evaluator_;
  std::vector<double> metrics_;
};

class TunedSource : public VariantSource {
 public:
  explicit TunedSource(std::shared_ptr<const VariantPlan> plan)
      : plan_(std::move(plan)),
        starts_(make_source(plan_->study, plan_->space)),
        workers_([this] { return Worker(plan_); }) {}

  std::uint64_t size() const override { return starts_->size(); }
  int rows_at_a_time() const override { return 1; }

  void values(std::uint64_t first, int count, std::span<double> rows) const override {
    starts_->values(first, count, rows);
    const std::size_t columns = std::size_t(plan_->space.column_count());
    Worker& worker = workers_.local();
    for (std::size_t row = 0; row < std::size_t(count); ++row)
      worker.tune(rows.subspan(row * columns, columns));
  }

 private:
  std::shared_ptr<const VariantPlan> plan_;
  std::unique_ptr<VariantSource> starts_;
  mutable tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace

std::unique_ptr<VariantSource> tuned_source(std::shared_ptr<const VariantPlan> plan) {
  return std::make_unique<TunedSource>(std::move(plan));
}

std::unique_ptr<VariantSource> plan_source(const std::shared_ptr<const VariantPlan>& plan) {
  const auto& optimizer = plan->study.optimizer;
  if (optimizer && optimizer->kind == OptimizerKind::local) return tuned_source(plan);
  return make_source(plan->study, plan->space);
}

}  // namespace bodyline::explore
