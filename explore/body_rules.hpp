#pragma once

#include <Eigen/Core>
#include <vector>

#include "explore/variant_status.hpp"
#include "model/body_plan.hpp"
#include "model/model.hpp"

namespace bodyline::explore {

/// The rules that `connect` (model/connect.hpp) sets for the numbers of a model which variables may
/// break: cuts in order, fullness and lean in range. Quick enough for every variant.
class BodyRules {
 public:
  BodyRules(const model::Model& model, const model::BodyPlan& plan);

  /// The first rule that parameters of the plan's layout break; its cause is 1 + the patch's index,
  /// or 1 + patches + the joint's.
  VariantOutcome check(const Eigen::VectorXd& parameters) const;

 private:
  struct Cut {
    int lower = 0;  // parameter; the upper end follows
    bool cut_below = false, cut_above = false;
    Cause cause = no_cause;
  };
  struct SeamLeans {  // of all sides that meet a seam at its end
    std::vector<int> parameters;
    Cause cause = no_cause;
  };
  std::vector<Cut> cuts_;
  std::vector<int> fullness_, leans_;  // parameters: two and four of each joint
  std::vector<SeamLeans> seams_;
  int patches_ = 0;
};

}  // namespace bodyline::explore
