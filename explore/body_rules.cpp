#include "explore/body_rules.hpp"

#include <cmath>

namespace bodyline::explore {

using model::Side;

BodyRules::BodyRules(const model::Model& model, const model::BodyPlan& plan)
    : patches_(int(model.patches.size())) {
  for (int p = 0; p < patches_; ++p) {
    const auto is_cut = [&](Side side) { return model::side_is_cut(model, plan.links, p, side); };
    const int first = plan.layout.cut(p);
    const Cause cause = Cause(1 + p);
    cuts_.push_back({first, is_cut(Side::u0), is_cut(Side::u1), cause});
    cuts_.push_back({first + 2, is_cut(Side::v0), is_cut(Side::v1), cause});
  }
  for (int j = 0; j < int(model.joints.size()); ++j) {
    for (int side = 0; side < 2; ++side) {
      fullness_.push_back(plan.layout.fullness(j, side));
      for (int end = 0; end < 2; ++end) leans_.push_back(plan.layout.lean(j, side, end));
    }
  }
  for (int c = 0; c < int(plan.links.corners.size()); ++c) {
    if (!plan.links.corners[c].seam) continue;
    SeamLeans seam;
    for (int j = 0; j < int(model.joints.size()); ++j) {
      for (int side = 0; side < 2; ++side) {
        for (int end = 0; end < 2; ++end) {
          if (plan.links.joints[j].corner[end] != c ||
              !model::lean_allowed(model, plan.links, j, side, end))
            continue;
          seam.parameters.push_back(plan.layout.lean(j, side, end));
          seam.cause = Cause(1 + patches_ + j);
        }
      }
    }
    seams_.push_back(seam);
  }
}

VariantOutcome BodyRules::check(const Eigen::VectorXd& parameters) const {
  for (const Cut& cut : cuts_) {
    const double lower = parameters[cut.lower], upper = parameters[cut.lower + 1];
    const bool in_order = lower >= 0.0 && lower < upper && upper <= 1.0;
    const bool uncut = (cut.cut_below && lower == 0.0) || (cut.cut_above && upper == 1.0);
    if (!in_order || uncut) return {VariantStatus::cut_order, cut.cause};
  }
  for (std::size_t k = 0; k < fullness_.size(); ++k) {
    const double fullness = parameters[fullness_[k]];
    if (!(fullness > model::min_fullness && fullness < model::max_fullness))
      return {VariantStatus::fullness, Cause(1 + patches_ + int(k) / 2)};
  }
  for (std::size_t k = 0; k < leans_.size(); ++k) {
    if (!(std::abs(parameters[leans_[k]]) <= model::max_lean))
      return {VariantStatus::lean, Cause(1 + patches_ + int(k) / 4)};
  }
  for (const SeamLeans& seam : seams_) {
    double sum = 0.0;
    for (const int parameter : seam.parameters) sum += std::abs(parameters[parameter]);
    if (sum < model::min_seam_lean) return {VariantStatus::lean, seam.cause};
  }
  return {};
}

}  // namespace bodyline::explore
