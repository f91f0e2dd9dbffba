#include "optimize/best_so_far.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimize/projected_gradient.hpp"

namespace bodyline::optimize {
namespace {

// Below this part of the start's value a value counts as zero in relative tolerances.
constexpr double negligible_value = 1e-12;

}  // namespace

BestSoFar::BestSoFar(ScaledProblem& problem, const Options& options)
    : problem_(problem), options_(options) {}

bool BestSoFar::start_run(const Eigen::VectorXd& y) {
  run_best_ = Point{};
  run_status_.reset();
  run_evaluations_ = 0;
  start_stage(0, 0);
  const bool first = evaluations_ == 0;
  if (!first && !may_evaluate()) return false;
  Eigen::VectorXd gradient;
  const std::optional<double> value =
      evaluate(problem_.clamped(y), uses_gradient(options_.algorithm) ? &gradient : nullptr);
  if (first && std::isfinite(run_best_.value)) start_value_ = run_best_.value;
  return value.has_value();
}

void BestSoFar::start_stage(int stall, int evaluations) {
  stage_over_ = stage_limit_reached_ = false;
  stage_evaluations_ = 0;
  stall_ = stall;
  stage_limit_ = evaluations;
  mark_evaluation_ = 0;
  mark_value_ = run_best_.value;
}

std::optional<double> BestSoFar::value(const Eigen::VectorXd& y, Eigen::VectorXd* gradient) {
  if (stage_over() || !y.allFinite()) return std::nullopt;
  const Eigen::VectorXd inside = problem_.clamped(y);
  const bool known = gradient == nullptr || run_best_.gradient.size() > 0;
  if (known && inside == run_best_.y) {
    if (gradient != nullptr) *gradient = run_best_.gradient;
    return run_best_.value;
  }
  if (!may_evaluate()) return std::nullopt;
  return evaluate(inside, gradient);
}

std::optional<double> BestSoFar::evaluate(const Eigen::VectorXd& y, Eigen::VectorXd* gradient) {
  try {
    ++evaluations_, ++run_evaluations_, ++stage_evaluations_;
    const double value = problem_.value(y, gradient);
    const bool usable = std::isfinite(value) && (gradient == nullptr || gradient->allFinite());
    if (!usable) ++unusable_evaluations_;
    // A start whose gradient cannot be evaluated still has a value to report.
    if (usable || (std::isfinite(value) && run_evaluations_ == 1)) {
      offer(y, value, usable ? gradient : nullptr);
    }
    end_stage_when_stalled();
    return usable ? std::optional<double>(value) : std::nullopt;
  } catch (...) {
    error_ = std::current_exception();
    return std::nullopt;
  }
}

bool BestSoFar::residuals(const Eigen::VectorXd& y, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
  if (stage_over() || !y.allFinite() || !may_evaluate()) return false;
  const Eigen::VectorXd inside = problem_.clamped(y);
  try {
    ++evaluations_, ++run_evaluations_, ++stage_evaluations_;
    problem_.residuals(inside, r, jacobian);
    const double value = r.squaredNorm();
    const bool usable = std::isfinite(value) && (jacobian == nullptr || jacobian->allFinite());
    if (!usable) {
      ++unusable_evaluations_;
    } else if (jacobian != nullptr) {
      const Eigen::VectorXd gradient = 2.0 * (jacobian->transpose() * r);
      offer(inside, value, &gradient);
    } else {
      offer(inside, value, nullptr);
    }
    end_stage_when_stalled();
    return usable;
  } catch (...) {
    error_ = std::current_exception();
    return false;
  }
}

bool BestSoFar::may_evaluate() {
  try {
    if (options_.should_stop && options_.should_stop()) run_status_ = Status::interrupted;
  } catch (...) {
    error_ = std::current_exception();
  }
  if (stage_over()) return false;
  if (options_.max_seconds > 0 && seconds() >= options_.max_seconds) {
    run_status_ = Status::time_limit;
  } else if (run_evaluations_ >= options_.max_evaluations) {
    run_status_ = Status::evaluation_limit;
  } else if (stage_limit_ > 0 && stage_evaluations_ >= stage_limit_) {
    stage_over_ = stage_limit_reached_ = true;
  }
  return !stage_over();
}

void BestSoFar::offer(const Eigen::VectorXd& y, double value, const Eigen::VectorXd* gradient) {
  Point point{y, value, {}, std::numeric_limits<double>::quiet_NaN()};
  if (gradient != nullptr) {
    point.gradient = *gradient;
    point.gradient_norm =
        projected_gradient(y, *gradient, problem_.lower(), problem_.upper()).norm();
  }
  if (value < run_best_.value) {
    accept(std::move(point));
  } else if (gradient != nullptr && value == run_best_.value) {
    learn_gradient(point);
  }
  const Point& best = run_best_;
  if (!run_status_ && best.gradient_norm <= options_.gradient_tolerance * value_size()) {
    run_status_ = Status::converged;
  }
}

void BestSoFar::accept(Point point) {
  run_best_ = std::move(point);
  if (!(run_best_.value < overall_best_.value)) return;
  overall_best_ = run_best_;
  history_.push_back({evaluations_, overall_best_.value, overall_best_.gradient_norm, seconds()});
  if (options_.on_progress) options_.on_progress(history_.back());
}

// The gradient may come after the value, at the same point; and of two points of equal value the
// one with the smaller gradient is the better.
void BestSoFar::learn_gradient(const Point& point) {
  const bool same = point.y == run_best_.y;
  if (!same && !(point.gradient_norm < run_best_.gradient_norm)) return;
  const bool overall = run_best_.y == overall_best_.y;
  run_best_ = point;
  if (!overall) return;
  overall_best_ = point;
  history_.back().gradient_norm = point.gradient_norm;
}

void BestSoFar::end_stage_when_stalled() {
  if (mark_value_ - run_best_.value > options_.relative_improvement * value_size()) {
    mark_value_ = run_best_.value;
    mark_evaluation_ = stage_evaluations_;
  } else if (stall_ > 0 && stage_evaluations_ - mark_evaluation_ >= stall_) {
    stage_over_ = true;
  }
}

bool BestSoFar::call_over() const {
  return run_status_ == Status::interrupted || run_status_ == Status::time_limit;
}

void BestSoFar::rethrow() const {
  if (error_ != nullptr) std::rethrow_exception(error_);
}

double BestSoFar::value_size() const {
  const double start = std::isfinite(start_value_) ? std::abs(start_value_) : 0.0;
  return std::max(std::abs(run_best_.value), negligible_value * start);
}

double BestSoFar::objective_size() const {
  double size = value_size();
  // Where the value passes zero the gradient still has a size.
  if (run_best_.gradient.size() > 0) size = std::max(size, 1e-6 * run_best_.gradient_norm);
  return size > 0 ? size : 1.0;
}

double BestSoFar::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

}  // namespace bodyline::optimize
