#include "strokes/measure_outcome.hpp"

#include <algorithm>
#include <limits>

#include "strokes/gave_way.hpp"

namespace bodyline::strokes {

void measure_outcome(StrokeOutcome& outcome, const SurfaceModel& surface,
                     const std::vector<StrokeMove>& moves, GivingWay giving_way) {
  outcome.deviation_mm = outcome.newest_deviation_mm = 0.0;
  for (const Eigen::Vector3d& point : outcome.asked) {
    const auto foot = surface.index.foot_point(surface.net, point);
    const double away =
        foot && foot->distance >= 0.0 ? foot->distance : std::numeric_limits<double>::infinity();
    outcome.deviation_mm = std::max(outcome.deviation_mm, away);
    const bool decided_later = giving_way == GivingWay::nearby
                                   ? gave_way(moves, outcome.number, point)
                                   : outcome.gave_way_mm > 0.0;
    if (!decided_later) outcome.newest_deviation_mm = std::max(outcome.newest_deviation_mm, away);
  }
}

}  // namespace bodyline::strokes
