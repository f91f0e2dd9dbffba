#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/body_plan.hpp"
#include "model/model.hpp"

/// Sizes of a car that users fix, bound or look at (docs/mathematics.md, section 9).
namespace bodyline::model {

enum class DimensionKind {
  length,          ///< along x, mm
  width,           ///< along y, mm
  height,          ///< from the body's lowest point to its highest, mm
  wheelbase,       ///< between the centres of the wheel arches, mm
  front_overhang,  ///< from the nose to the centre of the front arch, mm
  rear_overhang,   ///< from the centre of the rear arch to the tail, mm
  rake             ///< of a central patch: of its chord in the middle from the vertical, degrees
};

struct Dimension {
  DimensionKind kind = DimensionKind::length;
  int patch = -1;  ///< of a rake
};

/// "length", ..., "rake.windshield".
std::string dimension_name(const Model& model, const Dimension& dimension);
/// Throws std::invalid_argument, with the nearest name, when the model has no such dimension.
Dimension dimension_of(const Model& model, const std::string& name);
/// All that the model has: those of wheels when its arches have circles, a rake of each central
/// patch.
std::vector<Dimension> dimensions_of(const Model& model);

/// A dimension of a body and its derivative by the numbers of the nets (index, slope).
struct DimensionValue {
  double value = 0.0;  ///< mm or degrees
  std::vector<std::pair<int, double>> slopes;
};

/// Measures dimensions on nets. The extreme points that lengths are measured between move along the
/// body as it changes; to first order that does not count.
class DimensionMeter {
 public:
  /// `plan` is that of `model` and must outlive the meter.
  DimensionMeter(const Model& model, const BodyPlan& plan, Stage stage);

  /// Nets are xyz at the plan's offsets. Throws std::invalid_argument when an arch has no circle.
  DimensionValue measure(const Dimension& dimension, const double* nets) const;

 private:
  const BodyPlan* plan_;
  Stage stage_;
  /// Of the curves of both arches: the index in all nets of each of their points.
  std::vector<std::vector<int>> arches_[2];
};

}  // namespace bodyline::model
