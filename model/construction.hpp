#pragma once

#include <memory>
#include <vector>

#include "model/batch_bends.hpp"
#include "model/batch_construction.hpp"
#include "model/batch_plan.hpp"
#include "model/shaped_steps.hpp"

/// Parameters to nets, and back: the whole body, stage by stage, for any arithmetic type, one step
/// at a time. body_builder.hpp does the same with several steps at once.
namespace bodyline::model {

/// Working memory of one construction. `build` fills `nets`; `pullback` turns `nets_bar`, the
/// adjoints of all nets, into the adjoints of the parameters. Nothing is allocated after the
/// constructor. Not for two threads at once.
template <class Real>
class Construction {
 public:
  explicit Construction(const BodyPlan& plan)
      : nets(plan.point_count, Vec3<Real>{}),
        nets_bar(plan.point_count, Vec3<Real>{}),
        batches_(std::make_unique<BatchPlan>(plan, 1)),
        memory_(batches_->tables().memory),
        shaped_(plan) {}

  std::vector<Vec3<Real>> nets;      ///< all nets at the offsets of the plan
  std::vector<Vec3<Real>> nets_bar;  ///< adjoints; pullback overwrites parts of it

  /// Nets of all stages up to `stage` from the parameters (layout.size() of them).
  void build(const Real* parameters, Stage stage) {
    shaped_.build(parameters, stage == Stage::base, &nets[0].x);
    build_batches<Real>(batches_->tables(), last_stage(stage), parameters, &nets[0].x, storage());
    if (stage == Stage::body)
      build_bends<Real>(batches_->tables(), parameters, &nets[0].x, storage());
  }

  /// After build(parameters, stage): adds d / d parameter to `parameters_bar`. Consumes nets_bar.
  void pullback(const Real* parameters, Stage stage, Real* parameters_bar) {
    if (stage == Stage::body) {
      bends_pullback<Real>(batches_->tables(), parameters, storage(), &nets_bar[0].x,
                           parameters_bar);
    }
    batches_pullback<Real>(batches_->tables(), last_stage(stage), parameters, storage(),
                           &nets_bar[0].x, parameters_bar);
    shaped_.pullback(parameters, stage == Stage::base, &nets_bar[0].x, parameters_bar);
  }

 private:
  static LastStage last_stage(Stage stage) { return static_cast<LastStage>(stage); }
  unsigned char* storage() { return reinterpret_cast<unsigned char*>(memory_.data()); }

  std::unique_ptr<BatchPlan> batches_;
  std::vector<Real> memory_;
  ShapedSteps<Real> shaped_;
};

}  // namespace bodyline::model
