#pragma once

#include <memory>
#include <vector>

#include "model/scan.hpp"
#include "optimize/pull_moments.hpp"
#include "optimize/rim_samples.hpp"
#include "optimize/scan_edges.hpp"

namespace bodyline::optimize {

/// How strongly rims are drawn.
struct RimPullOptions {
  double reach = 100.0;  ///< longer gaps hardly pull, mm, off the surface and along it
  double rims = 0.0;     ///< weight of all rims in each direction, in points of the scan
  double edges = 0.0;    ///< weight of all edges, likewise
};

/// Matches of points on the body's rims, and pulls that bring the rims to the edges of a scan, both
/// ways and square to the rim: every edge draws the nearest rim that faces the same way, and every
/// point of a rim is drawn to the nearest such edge; along the rim, too, where the edge ends before
/// it, so that corners find theirs. A point without an edge is drawn back to where the scan ends.
/// No pull is longer than some millimetres: surfaces must keep up, and matches follow. (Where the
/// scan goes on beyond a rim its own points draw the rim out, see ScanFollower.)
class RimPuller {
 public:
  /// `scan` is folded and has normals; it, the plan and the edges must outlive the puller.
  RimPuller(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan,
            const std::vector<ScanEdge>& edges);
  ~RimPuller();

  /// Appends to both, one by one.
  void append(const double* nets, const RimPullOptions& options, std::vector<Match>& matches,
              std::vector<MatchPull>& pulls) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::optimize
