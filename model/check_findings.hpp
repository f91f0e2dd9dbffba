#pragma once

#include <string>
#include <vector>

#include "model/check_body.hpp"

namespace bodyline::model {

/// What a body may deviate before it is a finding. Construction is exact; what is left is rounding.
struct CheckTolerances {
  double gap_mm = 1e-6;
  double normal_deg = 1e-6;        ///< joints, seams after correction, corners
  double pillar_deg = 0.01;        ///< corners where a seam ends
  double printed_deg = 0.1;        ///< seams as printed
  double curvature_per_mm = 1e-9;  ///< joints with continuity 2
};

/// What is wrong with a body, one sentence each, the worst kind first: folded faces, gaps, normals
/// that differ, curvatures that jump at a joint with continuity 2. A seam that was printed with a
/// kink is a finding even though the construction corrects it. Empty when the body is fine.
std::vector<std::string> check_findings(const BodyCheck& check,
                                        const CheckTolerances& tolerances = {});

}  // namespace bodyline::model
