#pragma once

#include <memory>
#include <span>

#include "explore/variant_plan.hpp"
#include "explore/variant_status.hpp"

namespace bodyline::explore {

/// Measures variants, one at a time; one per thread. The result depends on the values alone, not on
/// what was measured before. Allocates nothing unless edges, scans
/// or outlines are measured.
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
