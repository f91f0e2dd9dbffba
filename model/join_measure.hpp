#pragma once

#include "model/family_curve.hpp"
#include "model/family_patch.hpp"
#include "model/patch_join.hpp"

/// How well two curves or patches of a family meet, measured on their jets, whatever made them.
namespace bodyline::model {

/// Largest deviations along a join.
struct JoinMeasure {
  double gap_mm = 0.0;         ///< between points of equal parameter
  double direction_deg = 0.0;  ///< between the normals of patches, or the tangents of curves
  double curvature_jump_per_mm = 0.0;  ///< of the curvature tensors, or of the curvature vectors
  double curvature_per_mm = 0.0;       ///< largest of either itself, to compare the jump with
};

/// At `samples` evenly spaced parameters along the join, ends included. The curvature tensor is
/// J I^-1 II I^-1 J' with J = [S_u S_v]: it does not depend on the parameters. A join is G1 where
/// gap and direction vanish, G2 where the jump does too.
JoinMeasure measure_join(const FamilyPatch& first, JoinDirection direction,
                         const FamilyPatch& second, int samples = 33);

/// At the end of the first curve and the start of the second.
JoinMeasure measure_join(const FamilyCurve& first, const FamilyCurve& second);

}  // namespace bodyline::model
