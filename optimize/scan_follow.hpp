#pragma once

#include <array>
#include <memory>
#include <vector>

#include "model/body_plan.hpp"
#include "model/scan.hpp"
#include "optimize/pull_moments.hpp"
#include "optimize/pull_reach.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {

/// The points of a scan laid out by the faces where they were matched. While a body moves a little
/// their foot points follow by some steps of Newton's method on the same faces, and become moments
/// in the same go: no point is touched twice.
class ScanFollower {
 public:
  /// `plan` and `scan` must outlive it; `rims` as rims_of gives them.
  ScanFollower(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan,
               std::vector<std::array<bool, 4>> rims, model::Isa isa = model::best_isa());
  ~ScanFollower();

  /// Takes matches of the scan's points, in their order.
  void start(const std::vector<Match>& matches);

  /// Moves the foot points to the body of these nets by `steps` steps and sums up the robust pulls
  /// there. Threads are those of oneTBB; the same bits for any number of them.
  std::vector<FaceMoments> follow(const double* nets, const PullReach& reach, int steps);

  /// Distances of the points at the last call of `follow`, mm, without sign; those on one face lie
  /// side by side.
  const std::vector<double>& distances() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::optimize
