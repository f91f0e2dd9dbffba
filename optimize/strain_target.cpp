#include "optimize/strain_target.hpp"

#include "model/strain.hpp"

namespace bodyline::optimize {
namespace {

class StrainTarget : public FitTarget {
 public:
  StrainTarget(const model::BodyPlan& plan, double weight) : plan_(&plan), weight_(weight) {}

  void match(const double* nets, const FitRound&) override {
    if (!term_) term_ = std::make_shared<model::Strain>(*plan_, nets);
  }
  model::WeightedNetTerm term() const override { return {term_, weight_}; }

 private:
  const model::BodyPlan* plan_;
  double weight_;
  std::shared_ptr<model::Strain> term_;
};

}  // namespace

FitTargetMaker strain_target(double weight) {
  return [weight](const model::BodyPlan& plan, model::Stage, FitDetail) {
    return std::make_unique<StrainTarget>(plan, weight);
  };
}

}  // namespace bodyline::optimize
