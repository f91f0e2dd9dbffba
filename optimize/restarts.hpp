#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

#include "optimize/scaled_problem.hpp"

namespace bodyline::optimize {

/// Seeded starts for further runs, in the scaled variables: uniform within `spread` times the
/// bounds' distance around the start (y = 0), cut at the bounds; within one unit where a bound is
/// infinite. The same sequence for the same seed on every machine.
class RestartSampler {
 public:
  RestartSampler(const ScaledProblem& problem, unsigned seed, double spread);
  Eigen::VectorXd next();

 private:
  const ScaledProblem& problem_;
  std::mt19937_64 generator_;
  double spread_;
};

}  // namespace bodyline::optimize
