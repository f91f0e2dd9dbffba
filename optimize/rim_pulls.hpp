#pragma once

#include <array>
#include <memory>
#include <vector>

#include "model/body_plan.hpp"
#include "optimize/pull_term.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {

/// Which sides of the faces of a stage are rims of the body (wheel arches, sill, lower edges): no
/// joint and no seam is there. By face and by model::Side; joints' and corners' faces have none.
std::vector<std::array<bool, 4>> rims_of(const model::BodyPlan& plan, model::Stage stage);

/// Matches of points on the body's rims, and pulls that draw the rims back to where the scan ends.
/// (Where the scan goes on beyond a rim its own points draw the rim out, see ScanFollower.)
class RimPuller {
 public:
  /// `scan` is folded and has normals; it and the plan must outlive the puller.
  RimPuller(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan);
  ~RimPuller();

  /// Appends to both. `reach`: gaps longer than this hardly pull, mm; `weight`: of all rims
  /// together, in points of the scan.
  void append(const double* nets, double reach, double weight, std::vector<Match>& matches,
              std::vector<MatchPull>& pulls) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::optimize
