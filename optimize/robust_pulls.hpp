#pragma once

#include <vector>

#include "optimize/scan_match.hpp"
#include "optimize/scan_term.hpp"

namespace bodyline::optimize {

/// Pulls along the body's normals towards the scan's points, weighted after Geman and McClure:
/// points `scale` mm away count a quarter, far ones and those turned away from the body nothing.
std::vector<MatchPull> robust_pulls(const std::vector<Match>& matches, const model::Scan& scan,
                                    double scale);

}  // namespace bodyline::optimize
