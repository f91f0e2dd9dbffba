#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/family_patch.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// A patch of a family as one Bezier patch: exact for polynomial families, within 1e-6 of its size
/// for H-Bezier, whose alphas must not exceed HBezierBasis::max_bezier_alpha. Throws as
/// check_patch.
Surface bezier_form(const FamilyPatch& patch);

/// Adjoints of the numbers of a FamilyPatch.
struct FamilyPatchBar {
  explicit FamilyPatchBar(const FamilyPatch& patch);  ///< all zero
  std::vector<Eigen::Vector3d> points;
  std::vector<double> shape_u, shape_v;
};

/// Adds the adjoints of the patch's numbers from those of its Bezier form's net.
void bezier_form_pullback(const FamilyPatch& patch, const std::vector<Eigen::Vector3d>& net_bar,
                          FamilyPatchBar& bar);

}  // namespace bodyline::model
