#pragma once

#include <array>

#include "optimize/pull_moments.hpp"
#include "optimize/pull_reach.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {

/// The pull of one point of a scan as the formula of model::Kernels::pulls has it, one number after
/// another; `normal` is null where the scan has none, `rims` are those of the match's face.
MatchPull robust_pull(const Match& match, const Eigen::Vector3d& point,
                      const Eigen::Vector3d* normal, const std::array<bool, 4>& rims,
                      const PullReach& reach, double least_rim_cosine);

}  // namespace bodyline::optimize
