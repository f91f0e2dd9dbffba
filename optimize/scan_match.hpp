#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "model/body_plan.hpp"
#include "model/kernels.hpp"
#include "model/scan.hpp"

namespace bodyline::optimize {

/// Where one point of a scan meets the body.
struct Match {
  int face = -1;  ///< index into the plan's faces of the stage
  double u = 0.0, v = 0.0;
  Eigen::Vector3d foot, normal;  ///< nearest point found, and the outward normal there
  double distance = 0.0;         ///< signed: positive outside of the body, mm
};

struct MatchOptions {
  double spacing = 40.0;         ///< of the samples that tell which face is near, mm
  int candidates = 2;            ///< faces tried for each point
  int steps = 12;                ///< of Newton's method
  double normal_length = 100.0;  ///< mm that a difference of 1 between normals counts
  double least_cosine = 0.2;     ///< between normals, for a face to be preferred
};

/// Finds for every point of a folded scan the nearest point of a body: the nearest samples tell
/// which faces to try, Newton's method does the rest.
class ScanMatcher {
 public:
  /// `scan` and `plan` must outlive it. Threads are those of oneTBB; results have the same bits for
  /// any number.
  ScanMatcher(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan,
              const MatchOptions& options = {}, model::Isa isa = model::best_isa());

  /// Matches at the nets (xyz at the plan's offsets), in the order of the scan's points.
  std::vector<Match> match(const double* nets) const;

 private:
  const model::BodyPlan* plan_;
  model::Stage stage_;
  const model::Scan* scan_;
  MatchOptions options_;
  const model::Kernels* kernels_;
};

}  // namespace bodyline::optimize
