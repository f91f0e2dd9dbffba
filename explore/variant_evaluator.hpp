#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "explore/design_space.hpp"
#include "explore/study.hpp"
#include "explore/variant_status.hpp"

namespace bodyline::explore {

/// What all threads that measure variants of a study share. Never changed after construction.
struct VariantPlan {
  /// Throws std::invalid_argument where a metric does not suit the models, and io::InputError for
  /// a scan that cannot be read.
  explicit VariantPlan(Study study);

  Study study;
  DesignSpace space;
  /// Names that a Cause counts: "" first, then patches, joints, faces and metrics.
  std::vector<std::string> causes;
};

/// Measures variants, one at a time and without allocating; one per thread. The result depends on
/// the values alone, not on what was measured before.
class VariantEvaluator {
 public:
  explicit VariantEvaluator(std::shared_ptr<const VariantPlan> plan);
  ~VariantEvaluator();
  VariantEvaluator(VariantEvaluator&&) noexcept;

  const VariantPlan& plan() const;

  /// One value per column of the space to one metric per MetricSpec of the study.
  VariantOutcome measure(std::span<const double> values, std::span<double> metrics);

  /// xyz of all nets of the variant measured last, at the offsets of the context's plan; of no
  /// meaning where it could not be built.
  std::span<const double> nets() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::explore
