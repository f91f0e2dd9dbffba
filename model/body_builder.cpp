#include "model/body_builder.hpp"

#include <stdexcept>
#include <vector>

#include "model/batch_bends.hpp"
#include "model/batch_plan.hpp"
#include "model/construction_lanes.hpp"
#include "model/shaped_steps.hpp"

namespace bodyline::model {
namespace {

const LaneConstruction& lane_construction(Isa isa) {
  if (!isa_available(isa))
    throw std::invalid_argument("this processor or build lacks the instruction set asked for");
#if defined(BODYLINE_X86_KERNELS)
  if (isa == Isa::avx512) return isa::avx512::construction();
  if (isa == Isa::avx2) return isa::avx2::construction();
#endif
  return isa::baseline::construction();
}

struct alignas(64) Block {
  unsigned char bytes[64];
};

class LaneBuilder final : public BodyBuilder {
 public:
  LaneBuilder(const BodyPlan& plan, const LaneConstruction& construction)
      : construction_(&construction),
        batches_(plan, construction.lanes),
        nets_(batches_.tables().number_count + spare),
        nets_bar_(batches_.tables().number_count + spare),
        memory_(batches_.tables().memory * sizeof(double) / sizeof(Block) + 1),
        shaped_(plan) {}

  void build(const double* parameters, Stage stage) override {
    shaped_.build(parameters, stage == Stage::base, nets_.data());
    construction_->build(batches_.tables(), static_cast<LastStage>(stage), parameters, nets_.data(),
                         memory_[0].bytes);
    if (stage == Stage::body)
      build_bends<double>(batches_.tables(), parameters, nets_.data(), memory_[0].bytes);
  }
  void pullback(const double* parameters, Stage stage, double* parameters_bar) override {
    if (stage == Stage::body) {
      bends_pullback<double>(batches_.tables(), parameters, memory_[0].bytes, nets_bar_.data(),
                             parameters_bar);
    }
    construction_->pullback(batches_.tables(), static_cast<LastStage>(stage), parameters,
                            memory_[0].bytes, nets_bar_.data(), parameters_bar);
    shaped_.pullback(parameters, stage == Stage::base, nets_bar_.data(), parameters_bar);
  }
  double* nets() override { return nets_.data(); }
  double* nets_bar() override { return nets_bar_.data(); }

 private:
  static constexpr int spare = 1;  // points are read as four numbers

  const LaneConstruction* construction_;
  BatchPlan batches_;
  std::vector<double> nets_, nets_bar_;
  std::vector<Block> memory_;
  ShapedSteps<double> shaped_;
};

}  // namespace

std::unique_ptr<BodyBuilder> make_body_builder(const BodyPlan& plan, Isa isa) {
  return std::make_unique<LaneBuilder>(plan, lane_construction(isa));
}

}  // namespace bodyline::model
