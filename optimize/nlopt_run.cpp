#include "optimize/nlopt_run.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace bodyline::optimize {
namespace {

constexpr int lbfgs_memory = 20;          // NLopt's own choice takes megabytes for few variables
constexpr double global_reach = 10.0;     // units searched where a bound is infinite
constexpr double cobyla_step = 0.5;       // first simplex, in units
constexpr double cobyla_accuracy = 1e-9;  // last simplex, in units
constexpr double bowl_height = 10.0;      // rise to a point without value, in sizes of the value

using Optimizer = std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)>;

nlopt_algorithm nlopt_name(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::nlopt_lbfgs:
      return NLOPT_LD_LBFGS;
    case Algorithm::nlopt_mma:
      return NLOPT_LD_MMA;
    case Algorithm::nlopt_ccsaq:
      return NLOPT_LD_CCSAQ;
    case Algorithm::nlopt_slsqp:
      return NLOPT_LD_SLSQP;
    case Algorithm::nlopt_cobyla:
      return NLOPT_LN_COBYLA;
    case Algorithm::nlopt_crs:
      return NLOPT_GN_CRS2_LM;
    case Algorithm::nlopt_direct:
      return NLOPT_GN_DIRECT_L;
    default:
      throw std::invalid_argument(algorithm_name(algorithm) + " is not an algorithm of NLopt.");
  }
}

/// What NLopt's callback needs. The objective is divided by `size`, because some of NLopt's
/// tolerances are absolute.
struct Call {
  BestSoFar& best;
  nlopt_opt optimizer;
  double size;
  Eigen::VectorXd y, gradient;
};

/// Value, and gradient when asked for, of a paraboloid with its lowest point at the best, as high
/// as the best there and `bowl_height` sizes higher at y.
double bowl(const Call& call, double* gradient) {
  const Point& best = call.best.run_best();
  const Eigen::VectorXd away = call.y - best.y;
  const double rise = bowl_height * (1.0 + std::abs(best.value) / call.size);
  if (gradient != nullptr) {
    Eigen::Map<Eigen::VectorXd> slope(gradient, away.size());
    const double distance = away.squaredNorm();
    slope = distance > 0 && std::isfinite(distance) ? Eigen::VectorXd(2.0 * rise / distance * away)
                                                    : Eigen::VectorXd::Zero(away.size());
  }
  return best.value / call.size + rise;
}

double objective(unsigned n, const double* y, double* gradient, void* data) {
  Call& call = *static_cast<Call*>(data);
  call.y = Eigen::Map<const Eigen::VectorXd>(y, n);
  const bool with_gradient = uses_gradient(call.best.options().algorithm);
  const std::optional<double> value =
      call.best.value(call.y, with_gradient ? &call.gradient : nullptr);
  if (call.best.stage_over()) nlopt_force_stop(call.optimizer);
  if (!value) return bowl(call, gradient);
  if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, n) = call.gradient / call.size;
  return *value / call.size;
}

void require(nlopt_result result, nlopt_opt optimizer) {
  if (result >= 0) return;
  if (result == NLOPT_OUT_OF_MEMORY) throw std::bad_alloc();
  const char* reason = nlopt_get_errmsg(optimizer);
  throw std::runtime_error("NLopt refused its arguments" +
                           (reason ? ": " + std::string(reason) : std::string()) + ".");
}

void set_bounds(nlopt_opt optimizer, const BestSoFar& best, Algorithm algorithm) {
  Eigen::VectorXd lower = best.problem().lower(), upper = best.problem().upper();
  if (is_global(algorithm)) {
    const Eigen::VectorXd& y = best.run_best().y;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      if (std::isinf(lower[i])) lower[i] = y[i] - global_reach;
      if (std::isinf(upper[i])) upper[i] = y[i] + global_reach;
    }
  }
  require(nlopt_set_lower_bounds(optimizer, lower.data()), optimizer);
  require(nlopt_set_upper_bounds(optimizer, upper.data()), optimizer);
}

void set_up(nlopt_opt optimizer, Call& call, Algorithm algorithm) {
  require(nlopt_set_min_objective(optimizer, objective, &call), optimizer);
  set_bounds(optimizer, call.best, algorithm);
  if (uses_gradient(algorithm)) {
    require(nlopt_set_ftol_rel(optimizer, call.best.options().relative_improvement), optimizer);
  }
  if (algorithm == Algorithm::nlopt_lbfgs) {
    require(nlopt_set_vector_storage(optimizer, lbfgs_memory), optimizer);
  }
  if (algorithm == Algorithm::nlopt_cobyla) {
    require(nlopt_set_initial_step1(optimizer, cobyla_step), optimizer);
    require(nlopt_set_xtol_abs1(optimizer, cobyla_accuracy), optimizer);
  }
}

}  // namespace

bool run_nlopt(BestSoFar& best, Algorithm algorithm, unsigned seed) {
  const auto n = static_cast<unsigned>(best.problem().size());
  const Optimizer optimizer(nlopt_create(nlopt_name(algorithm), n), nlopt_destroy);
  if (optimizer == nullptr) throw std::bad_alloc();
  Call call{best, optimizer.get(), best.objective_size(), {}, {}};
  set_up(optimizer.get(), call, algorithm);
  nlopt_srand(seed);
  Eigen::VectorXd y = best.run_best().y;
  double value = 0;
  const nlopt_result result = nlopt_optimize(optimizer.get(), y.data(), &value);
  best.rethrow();
  if (result == NLOPT_INVALID_ARGS || result == NLOPT_OUT_OF_MEMORY) {
    require(result, optimizer.get());
  }
  return result == NLOPT_XTOL_REACHED;
}

}  // namespace bodyline::optimize
