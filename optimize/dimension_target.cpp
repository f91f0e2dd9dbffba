#include "optimize/dimension_target.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

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

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string interval(const DimensionBound& bound) {
  const std::string lower = number(bound.lower), upper = number(bound.upper);
  return lower == upper ? lower : lower + " to " + upper;
}

bool is_angle(model::DimensionKind kind) { return kind == model::DimensionKind::rake; }

// "At most 4500" may be written 0:4500: an interval need only meet the range.
void check_range(const DimensionBound& bound, model::DimensionKind kind) {
  const auto [least, most] = possible_range(kind);
  const bool finite = std::isfinite(bound.lower) && std::isfinite(bound.upper);
  if (finite && bound.lower <= most && bound.upper >= least) return;
  throw std::invalid_argument(bound.name + " is from " + number(least) + " to " + number(most) +
                              (is_angle(kind) ? " degrees" : " mm") + ", not " + interval(bound));
}

}  // namespace

DimensionRange possible_range(model::DimensionKind kind) {
  using enum model::DimensionKind;
  if (is_angle(kind)) return {0.0, 90.0};
  // An overhang is negative where an arch is open at the end of the car.
  if (kind == front_overhang || kind == rear_overhang) return {-1000.0, 10000.0};
  return {100.0, 20000.0};
}

std::vector<DimensionBound> merged(const std::vector<DimensionBound>& bounds) {
  std::vector<DimensionBound> result;
  for (const DimensionBound& bound : bounds) {
    const auto same = std::find_if(result.begin(), result.end(), [&](const DimensionBound& other) {
      return other.name == bound.name;
    });
    if (same == result.end()) {
      result.push_back(bound);
      continue;
    }
    if (bound.lower > same->upper || bound.upper < same->lower) {
      throw std::invalid_argument(bound.name + " is asked for more than once, and " +
                                  interval(*same) + " and " + interval(bound) +
                                  " exclude each other");
    }
    same->lower = std::max(same->lower, bound.lower);
    same->upper = std::min(same->upper, bound.upper);
  }
  return result;
}

FitTargetMaker dimension_target(const model::Model& model,
                                const std::vector<DimensionBound>& bounds) {
  std::vector<Bounded> checked;
  for (const DimensionBound& bound : bounds) {
    if (bound.lower > bound.upper)
      throw std::invalid_argument("the bounds of '" + bound.name + "' are in the wrong order");
    const model::Dimension dimension = model::dimension_of(model, bound.name);
    check_range(bound, dimension.kind);
    checked.push_back({dimension, bound.lower, bound.upper});
  }
  return [model, checked](const model::BodyPlan& plan, model::Stage stage, FitDetail) {
    return std::make_unique<DimensionTarget>(model, plan, stage, checked);
  };
}

}  // namespace bodyline::optimize
