#pragma once

#include <vector>

#include "model/silhouette.hpp"
#include "optimize/outline_samples.hpp"
#include "optimize/pull_reach.hpp"
#include "optimize/pull_term.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {

/// How an outline is matched with a silhouette.
struct OutlineMatching {
  PullReach reach;
  bool from_body = true;  ///< the silhouette's points pull too, to their nearest of the drawing
};

/// Matches of points of silhouettes, and what pulls at them in the picture; see PullTerm.
struct OutlinePulls {
  std::vector<Match> matches;
  std::vector<MatchPull> pulls;
  std::vector<double> distances;  ///< of the drawing's points from the silhouette, mm, signed
};

/// Matches an outline both ways with the silhouette `pieces` of a body in the outline's view. The
/// motion of a silhouette along its picture normal is n . dS at fixed (u, v) (docs/mathematics.md,
/// section 9), so its points pull like those of a scan whose normals lie in the picture. Weights
/// are after Geman and McClure, per length of outline, and fall with the angle between normals.
OutlinePulls match_outline(const model::SilhouetteBody& body,
                           const std::vector<model::SilhouetteCurve>& pieces,
                           const OutlineSamples& samples, const OutlineMatching& matching);

}  // namespace bodyline::optimize
