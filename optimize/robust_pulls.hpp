#pragma once

#include <array>
#include <vector>

#include "optimize/scan_match.hpp"
#include "optimize/scan_moments.hpp"

namespace bodyline::optimize {

/// How far a scan's points are heeded, mm.
struct PullReach {
  double normal = 0.0;  ///< off the surface: points so far away count a quarter
  double rim = 0.0;     ///< beyond a rim of the body, likewise
};

/// The pull of one point; `normal` is null where the scan has none, `rims` are those of its face.
MatchPull robust_pull(const Match& match, const Eigen::Vector3d& point,
                      const Eigen::Vector3d* normal, const std::array<bool, 4>& rims,
                      const PullReach& reach);

/// Pulls along the body's normals towards the scan's points, weighted after Geman and McClure;
/// where the scan goes on beyond a rim, also along the surface. Points that are turned away from
/// the body count nothing.
std::vector<MatchPull> robust_pulls(const std::vector<Match>& matches, const model::Scan& scan,
                                    const std::vector<std::array<bool, 4>>& rims,
                                    const PullReach& reach);

}  // namespace bodyline::optimize
