#include "optimize/dimension_target.hpp"

#include <stdexcept>

#include "model/largest_coordinate.hpp"
#include "optimize/bounded_target.hpp"

namespace bodyline::optimize {
namespace {

// A degree of rake moves the end of a windshield by about so much, mm.
constexpr double mm_per_degree = 15.0;

struct Bounded {
  model::Dimension dimension;
  double lower, upper;
};

class DimensionTarget : public BoundedTarget {
 public:
  DimensionTarget(const model::Model& model, const model::BodyPlan& plan, model::Stage stage,
                  std::vector<Bounded> bounds)
      : BoundedTarget(plan, stage), meter_(model, plan, stage), bounds_(std::move(bounds)) {}

 private:
  std::vector<NetRow> measure(const double* nets) override;

  model::DimensionMeter meter_;
  std::vector<Bounded> bounds_;
};

std::vector<NetRow> DimensionTarget::measure(const double* nets) {
  std::vector<NetRow> rows;
  for (const Bounded& bound : bounds_) {
    const double unit = bound.dimension.kind == model::DimensionKind::rake ? mm_per_degree : 1.0;
    model::DimensionValue measured = meter_.measure(bound.dimension, nets);
    NetRow row{std::move(measured.slopes), unit * measured.value, unit * bound.lower,
               unit * bound.upper};
    for (auto& [number, slope] : row.slopes) {
      slope *= unit;
      row.offset -= slope * nets[number];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

FitTargetMaker dimension_target(const model::Model& model,
                                const std::vector<DimensionBound>& bounds) {
  std::vector<Bounded> checked;
  for (const DimensionBound& bound : bounds) {
    if (!(bound.lower <= bound.upper))
      throw std::invalid_argument("the bounds of '" + bound.name + "' are in the wrong order");
    if (bound.lower < -model::largest_coordinate || bound.upper > model::largest_coordinate)
      throw std::invalid_argument("the bounds of '" + bound.name + "' must lie within 1 km");
    checked.push_back({model::dimension_of(model, bound.name), bound.lower, bound.upper});
  }
  return [model, checked](const model::BodyPlan& plan, model::Stage stage, FitDetail) {
    return std::make_unique<DimensionTarget>(model, plan, stage, checked);
  };
}

}  // namespace bodyline::optimize
