#include "optimize/ceres_lbfgs.hpp"

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "optimize/bounded_map.hpp"
#include "optimize/ceres_stop.hpp"
#include "optimize/movable_variables.hpp"

namespace bodyline::optimize {
namespace {

// A variable that is pulled off a bound starts at least this many units inside.
constexpr double hair = 1e-4;

struct Searched {
  Eigen::Index index;
  BoundedMap map;
};

/// The variables to search, and the point z to start from.
std::vector<Searched> choose(const BestSoFar& best, std::vector<double>& z) {
  const Point& point = best.run_best();
  std::vector<Searched> chosen;
  for (const Eigen::Index i : movable_variables(best)) {
    const BoundedMap map{best.problem().lower()[i], best.problem().upper()[i]};
    const double y = point.gradient[i] < 0 ? std::max(point.y[i], map.lower + hair)
                                           : std::min(point.y[i], map.upper - hair);
    chosen.push_back({i, map});
    z.push_back(map.outside(y));
  }
  return chosen;
}

class MappedFunction final : public ceres::FirstOrderFunction {
 public:
  MappedFunction(BestSoFar& best, std::vector<Searched> searched)
      : best_(best),
        searched_(std::move(searched)),
        y_(best.run_best().y),
        size_(best.objective_size()) {}

  bool Evaluate(const double* z, double* cost, double* gradient) const override {
    for (std::size_t k = 0; k < searched_.size(); ++k) {
      y_[searched_[k].index] = searched_[k].map.inside(z[k]);
    }
    const std::optional<double> value = best_.value(y_, &gradient_);
    if (!value) return false;
    *cost = *value / size_;
    if (gradient == nullptr) return true;
    for (std::size_t k = 0; k < searched_.size(); ++k) {
      const auto& [index, map] = searched_[k];
      gradient[k] = gradient_[index] * map.inside_derivative(z[k]) / size_;
    }
    return true;
  }

  int NumParameters() const override { return static_cast<int>(searched_.size()); }

 private:
  BestSoFar& best_;
  std::vector<Searched> searched_;
  mutable Eigen::VectorXd y_, gradient_;
  double size_;  // of the objective: Ceres skips updates that are small in absolute terms
};

}  // namespace

void run_ceres_lbfgs(BestSoFar& best) {
  std::vector<double> z;
  const std::vector<Searched> searched = choose(best, z);
  if (searched.empty()) return;
  const ceres::GradientProblem problem(new MappedFunction(best, searched));
  CeresStop stop(best);
  ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = ceres::LBFGS;
  options.line_search_type = ceres::WOLFE;
  // Without it Ceres starts each direction from an unscaled gradient and takes many times the
  // evaluations.
  options.use_approximate_eigenvalue_bfgs_scaling = true;
  options.max_num_iterations = std::numeric_limits<int>::max();
  options.function_tolerance = best.options().relative_improvement;
  options.gradient_tolerance = 0.0;  // judged by BestSoFar
  options.parameter_tolerance = 0.0;
  options.logging_type = ceres::SILENT;
  options.callbacks.push_back(&stop);
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, problem, z.data(), &summary);
  best.rethrow();
}

}  // namespace bodyline::optimize
