#include "optimize/restarts.hpp"

#include <cmath>

namespace bodyline::optimize {
namespace {

// The distributions of the standard library differ between libraries.
double between_minus_one_and_one(std::mt19937_64& generator) {
  return std::ldexp(static_cast<double>(generator() >> 11), -52) - 1.0;
}

}  // namespace

RestartSampler::RestartSampler(const ScaledProblem& problem, unsigned seed, double spread)
    : problem_(problem), generator_(seed), spread_(spread) {}

Eigen::VectorXd RestartSampler::next() {
  Eigen::VectorXd y(problem_.size());
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double width = problem_.upper()[i] - problem_.lower()[i];
    const double reach = std::isfinite(width) ? spread_ * width : 1.0;
    y[i] = reach * between_minus_one_and_one(generator_);
  }
  return problem_.clamped(y);
}

}  // namespace bodyline::optimize
