#pragma once

#include <filesystem>
#include <vector>

#include "explore/study.hpp"
#include "model/body_plan.hpp"
#include "model/model.hpp"
#include "optimize/outline_samples.hpp"

namespace bodyline::explore {

/// How far the silhouettes of variants lie from drawn outlines: the root mean square, over all
/// views, of the distances of the drawings' points from the silhouettes and of the silhouettes'
/// from the drawings, without the farthest tenth, mm. Where a drawing ends, or is open on both of
/// its sides, only its own points count.
class OutlineMeter {
 public:
  /// Reads the drawings of a metric and lays them where `model` lies (io/place_drawings.hpp);
  /// `plan` is that of the model and must outlive the meter. Throws io::InputError for a file and
  /// StudyError for drawings that cannot be placed.
  OutlineMeter(const std::filesystem::path& folder, const MetricSpec& metric,
               const model::Model& model, const model::BodyPlan& plan);

  /// Safe to call from several threads.
  double measure(const double* nets) const;

 private:
  const model::BodyPlan* plan_;
  std::vector<optimize::OutlineSamples> outlines_;
};

}  // namespace bodyline::explore
