#pragma once

#include <memory>

#include "model/body_plan.hpp"
#include "model/kernels.hpp"

namespace bodyline::model {

/// Parameters to nets, and back, for the whole body. `build` and `pullback` allocate nothing. Not
/// for two threads at once. The plan must outlive it.
class BodyBuilder {
 public:
  virtual ~BodyBuilder() = default;

  /// Nets of all stages up to `stage` from the parameters (layout.size() of them).
  virtual void build(const double* parameters, Stage stage) = 0;

  /// After build(parameters, stage): adds d / d parameter to `parameters_bar`, from the adjoints in
  /// nets_bar(), parts of which are overwritten.
  virtual void pullback(const double* parameters, Stage stage, double* parameters_bar) = 0;

  /// xyz of all points at the plan's offsets, 3 * plan.point_count numbers, and their adjoints.
  virtual double* nets() = 0;
  virtual double* nets_bar() = 0;
};

/// Builds as many steps of a kind at once as a vector of the instruction set has lanes. Throws
/// std::invalid_argument when this processor or build does not have the set.
std::unique_ptr<BodyBuilder> make_body_builder(const BodyPlan& plan, Isa isa);

}  // namespace bodyline::model
