#pragma once

#include <ceres/iteration_callback.h>

#include "optimize/best_so_far.hpp"

namespace bodyline::optimize {

/// Ends a solve of Ceres once the stage is over.
class CeresStop final : public ceres::IterationCallback {
 public:
  explicit CeresStop(const BestSoFar& best) : best_(best) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& /*summary*/) override {
    return best_.stage_over() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const BestSoFar& best_;
};

}  // namespace bodyline::optimize
