#pragma once

#include <memory>
#include <string>
#include <vector>

#include "explore/design_space.hpp"
#include "explore/outline_meter.hpp"
#include "explore/scan_meter.hpp"
#include "explore/study.hpp"

namespace bodyline::explore {

/// What all threads that measure variants of a study share. Never changed after construction.
struct VariantPlan {
  /// Throws StudyError where something does not suit the models, and io::InputError for a scan or
  /// a drawing that cannot be read.
  explicit VariantPlan(Study of);

  Study study;
  DesignSpace space;
  std::vector<std::string> causes;                ///< names that a Cause counts
  std::vector<std::unique_ptr<ScanMeter>> scans;  ///< of each metric; null where it is no scan
  std::vector<std::unique_ptr<OutlineMeter>> outlines;  ///< likewise
};

/// The names that causes of a study count: "" first, then faces of the closed body (patches,
/// joints, corners) and metrics.
std::vector<std::string> cause_names(const Study& study, const DesignSpace& space);

/// A metric that is a term of an objective as one, of weight 1.
model::Term term_of(const MetricSpec& metric);

/// The terms of an objective among the metrics, in their order, each with weight 1: those that one
/// evaluator measures together, and by themselves the variations after the first, of which it can
/// hold one.
struct MetricTerms {
  std::vector<model::Term> together, apart;
};
MetricTerms metric_terms(const Study& study);

/// Checks that all metrics suit the models; scans are not read. Throws StudyError.
void check_metrics(const Study& study, const DesignSpace& space);

}  // namespace bodyline::explore
