#pragma once

#include <random>
#include <string>

#include "model/family_curve.hpp"
#include "model/patch_chain.hpp"

namespace bodyline::testing {

/// Shape parameters anywhere in the range that is drawn from: that of the family, H-Bezier up to 6.
std::vector<double> random_shape(const std::string& family, int degree, int sets,
                                 std::mt19937& random);

/// A patch over a bumpy square of 300 mm whose lower left corner is at `origin`.
model::FamilyPatch random_patch(const std::string& family, int degree_u, int degree_v,
                                const Eigen::Vector3d& origin, std::mt19937& random);

/// A bumpy curve 300 mm long.
model::FamilyCurve random_curve(const std::string& family, int degree, std::mt19937& random);

/// Gives both patches of a join the shape parameters that it ties.
void share_shapes(model::FamilyPatch& first, const model::PatchJoin& join,
                  model::FamilyPatch& second);

/// Three patches joined along u, then round the corner, then along v, with free rows that make
/// sense; propagated.
model::PatchChain random_chain(const std::string& family, int continuity, std::mt19937& random);

}  // namespace bodyline::testing
