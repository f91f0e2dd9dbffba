#include "optimize/constrained_search.hpp"

#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

namespace bodyline::optimize {
namespace {

constexpr double bowl_rise = 10.0;      // of a function to a point without value, in its units
constexpr double aim_tolerance = 1e-9;  // by which an aim may exceed the bound on all
constexpr double smallest_step = 1e-9;  // in the cube
constexpr double worthwhile = 100.0;    // gain of a call of NLopt, in tolerances, for another
constexpr double infinity = std::numeric_limits<double>::infinity();

using Optimizer = std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)>;

// All that NLopt evaluates goes through here. With several aims the variables are x and, behind
// them, a bound on the aims, which is what is minimized.
class Run {
 public:
  Run(SmoothFunctions& functions, const Eigen::VectorXd& start, const ConstrainedSearch& search)
      : functions_(functions), search_(search) {
    x_ = start.cwiseMax(0.0).cwiseMin(1.0);
    ++best_.evaluations;
    if (!functions_.evaluate(x_, values_, jacobian_)) return;
    for (Aim& aim : search_.aims) {
      const double size = std::abs(values_[aim.function]);
      if (aim.unit <= 0.0) aim.unit = size > 0.0 ? size : 1.0;
    }
    offer();
  }

  bool has_start() const { return best_.values.size() > 0; }
  ConstrainedResult optimize();

 private:
  bool bounded() const { return search_.aims.size() > 1; }
  double aim(std::size_t k, const Eigen::VectorXd& values) const {
    const Aim& aim = search_.aims[k];
    return (values[aim.function] - aim.reference) / aim.unit;
  }
  double unit_of(int function) const {
    for (const Aim& aim : search_.aims) {
      if (aim.function == function) return aim.unit;
    }
    return 1.0;
  }
  void evaluate();
  void stage(nlopt_opt optimizer);
  void offer();
  void show_bowl();
  void move_to(unsigned n, const double* y);
  double objective(unsigned n, const double* y, double* gradient);
  void constraints(unsigned m, double* result, unsigned n, const double* y, double* gradient);
  unsigned constraint_count() const {
    return unsigned(functions_.count() - search_.first_constraint) +
           (bounded() ? unsigned(search_.aims.size()) : 0u);
  }

  static double call_objective(unsigned n, const double* y, double* gradient, void* data) {
    return static_cast<Run*>(data)->objective(n, y, gradient);
  }
  static void call_constraints(unsigned m, double* result, unsigned n, const double* y,
                               double* gradient, void* data) {
    static_cast<Run*>(data)->constraints(m, result, n, y, gradient);
  }

  SmoothFunctions& functions_;
  ConstrainedSearch search_;
  Eigen::VectorXd x_, values_;  // the last evaluation
  Eigen::MatrixXd jacobian_;
  ConstrainedResult best_;
  nlopt_opt optimizer_ = nullptr;
  bool over_ = false;
  std::exception_ptr error_;
};

void Run::offer() {
  double violation = 0.0, largest = -infinity;
  for (int k = search_.first_constraint; k < functions_.count(); ++k)
    violation += std::max(0.0, values_[k]);
  for (std::size_t k = 0; k < search_.aims.size(); ++k)
    largest = std::max(largest, aim(k, values_));
  const bool is_better = best_.values.size() == 0 || violation < best_.violation ||
                         (violation == best_.violation && largest < best_.largest);
  if (!is_better) return;
  best_.x = x_;
  best_.values = values_;
  best_.largest = largest;
  best_.violation = violation;
}

// A paraboloid around the best point in place of functions that have no value, so that line
// searches step back.
void Run::show_bowl() {
  const Eigen::VectorXd away = x_ - best_.x;
  const double distance = std::max(away.squaredNorm(), smallest_step * smallest_step);
  values_ = best_.values;
  jacobian_.resize(functions_.count(), x_.size());
  for (int k = 0; k < functions_.count(); ++k) {
    const double rise = bowl_rise * unit_of(k);
    values_[k] += rise;
    jacobian_.row(k) = 2.0 * rise / distance * away;
  }
}

void Run::evaluate() {
  ++best_.evaluations;
  if (functions_.evaluate(x_, values_, jacobian_)) {
    offer();
  } else {
    show_bowl();
  }
}

// Stays at the last point when nothing may be evaluated any more.
void Run::move_to(unsigned n, const double* y) {
  const Eigen::Map<const Eigen::VectorXd> given(y, Eigen::Index(n) - (bounded() ? 1 : 0));
  const Eigen::VectorXd x = given.cwiseMax(0.0).cwiseMin(1.0);
  if (x == x_) return;
  if (error_ == nullptr && best_.evaluations < search_.max_evaluations &&
      !(search_.should_stop && search_.should_stop())) {
    try {
      x_ = x;
      evaluate();
      return;
    } catch (...) {
      error_ = std::current_exception();
    }
  }
  over_ = true;
  nlopt_force_stop(optimizer_);
}

double Run::objective(unsigned n, const double* y, double* gradient) {
  move_to(n, y);
  if (bounded()) {
    if (gradient != nullptr) {
      std::fill_n(gradient, n, 0.0);
      gradient[n - 1] = 1.0;
    }
    return y[n - 1];
  }
  const Aim& aim = search_.aims.front();
  if (gradient != nullptr)
    Eigen::Map<Eigen::RowVectorXd>(gradient, n) = jacobian_.row(aim.function) / aim.unit;
  return this->aim(0, values_);
}

void Run::constraints(unsigned m, double* result, unsigned n, const double* y, double* gradient) {
  move_to(n, y);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  unsigned row = 0;
  const auto set = [&](double value, int function, double unit, double bound_slope) {
    result[row] = value;
    if (gradient != nullptr) {
      Eigen::Map<Rows> slopes(gradient, m, n);
      slopes.row(row).head(x_.size()) = jacobian_.row(function) / unit;
      if (bounded()) slopes(row, Eigen::Index(n) - 1) = bound_slope;
    }
    ++row;
  };
  for (int k = search_.first_constraint; k < functions_.count(); ++k) set(values_[k], k, 1.0, 0.0);
  if (!bounded()) return;
  for (std::size_t k = 0; k < search_.aims.size(); ++k)
    set(aim(k, values_) - y[n - 1], search_.aims[k].function, search_.aims[k].unit, -1.0);
}

nlopt_algorithm nlopt_name(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::nlopt_slsqp:
      return NLOPT_LD_SLSQP;
    case Algorithm::nlopt_mma:
      return NLOPT_LD_MMA;
    case Algorithm::nlopt_ccsaq:
      return NLOPT_LD_CCSAQ;
    default:
      throw std::invalid_argument(algorithm_name(algorithm) +
                                  " keeps no constraints; nlopt-slsqp, nlopt-mma and nlopt-ccsaq "
                                  "do.");
  }
}

// One call of NLopt from the best point.
void Run::stage(nlopt_opt optimizer) {
  Eigen::VectorXd y(x_.size() + (bounded() ? 1 : 0));
  y.head(x_.size()) = best_.x;
  if (bounded()) y[y.size() - 1] = best_.largest;
  double value = 0.0;
  const nlopt_result result = nlopt_optimize(optimizer, y.data(), &value);
  if (error_ != nullptr) std::rethrow_exception(error_);
  if (result == NLOPT_OUT_OF_MEMORY) throw std::bad_alloc();
}

ConstrainedResult Run::optimize() {
  const Eigen::Index size = x_.size() + (bounded() ? 1 : 0);
  const Optimizer optimizer(nlopt_create(nlopt_name(search_.algorithm), unsigned(size)),
                            nlopt_destroy);
  if (optimizer == nullptr) throw std::bad_alloc();
  optimizer_ = optimizer.get();
  Eigen::VectorXd lower = Eigen::VectorXd::Zero(size), upper = Eigen::VectorXd::Ones(size);
  if (bounded()) {
    lower[size - 1] = -infinity;
    upper[size - 1] = infinity;
  }
  nlopt_set_lower_bounds(optimizer_, lower.data());
  nlopt_set_upper_bounds(optimizer_, upper.data());
  nlopt_set_min_objective(optimizer_, call_objective, this);
  const std::vector<double> tolerances(constraint_count(), aim_tolerance);
  if (!tolerances.empty()) {
    nlopt_add_inequality_mconstraint(optimizer_, constraint_count(), call_constraints, this,
                                     tolerances.data());
  }
  nlopt_set_ftol_abs(optimizer_, search_.tolerance);
  nlopt_set_xtol_abs1(optimizer_, smallest_step);
  double largest, violation;
  do {
    largest = best_.largest;
    violation = best_.violation;
    stage(optimizer_);
  } while (!over_ && (best_.violation < violation ||
                      largest - best_.largest > worthwhile * search_.tolerance));
  return best_;
}

}  // namespace

bool keeps_constraints(Algorithm algorithm) {
  return algorithm == Algorithm::nlopt_slsqp || algorithm == Algorithm::nlopt_mma ||
         algorithm == Algorithm::nlopt_ccsaq;
}

ConstrainedResult search_constrained(SmoothFunctions& functions, const Eigen::VectorXd& start,
                                     const ConstrainedSearch& search) {
  nlopt_name(search.algorithm);
  Run run(functions, start, search);
  if (!run.has_start()) {
    ConstrainedResult none;
    none.x = start.cwiseMax(0.0).cwiseMin(1.0);
    none.evaluations = 1;
    return none;
  }
  return run.optimize();
}

}  // namespace bodyline::optimize
