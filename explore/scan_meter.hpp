#pragma once

#include <filesystem>
#include <memory>

#include "explore/study.hpp"
#include "model/body_plan.hpp"
#include "model/model.hpp"
#include "model/scan.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::explore {

/// How far a scan lies from variants: the root mean square distance of the nearest 90 % of its
/// points, mm, the "trimmed_rms" of optimize/deviation.hpp.
class ScanMeter {
 public:
  /// Reads the scan of a metric and finds its pose on `model`, unless it is posed; `plan` is that
  /// of the model and must outlive the meter. Throws io::InputError and std::invalid_argument.
  ScanMeter(const std::filesystem::path& file, const MetricSpec& metric, const model::Model& model,
            const model::BodyPlan& plan);

  /// Safe to call from several threads.
  double measure(const double* nets) const;

 private:
  std::unique_ptr<const model::Scan> scan_;
  optimize::ScanMatcher matcher_;
};

}  // namespace bodyline::explore
