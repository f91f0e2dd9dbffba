#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/body_plan.hpp"
#include "model/kernels.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {

/// What one match asks of its face: (S(u,v) - target)' W (S(u,v) - target) should be small.
struct MatchPull {
  Eigen::Vector3d target;
  Eigen::Matrix3d weight;  ///< W, symmetric, not negative; all zero leaves the match out
};

/// Sums over points of one face, from which its least squares follow (docs/fitting.md).
struct FaceMoments {
  FaceMoments(const model::Face& face, int index);

  void add(const model::Kernels& kernels, const model::Face& face, const model::PullArrays& pulls,
           const model::PullSums& sums);
  void add(const FaceMoments& other);

  int face = -1;                      ///< index into the stage's faces
  std::vector<double> second, first;  ///< see Kernels::add_moments
  double constant = 0.0;              ///< sum of target' W target
  double weight = 0.0;                ///< sum of the traces of W
};

/// The moments of matches by face, in the order of the faces; `pulls` belong to `matches` one by
/// one. Pillar feet, whose Gregory terms have no moments, are left out. Runs on the threads of
/// oneTBB, with the same bits for any number of them.
std::vector<FaceMoments> collect_moments(const std::vector<model::Face>& faces,
                                         const model::Kernels& kernels,
                                         const std::vector<Match>& matches,
                                         const std::vector<MatchPull>& pulls);

/// Adds `other` to `sums`, face by face.
void merge_moments(const std::vector<FaceMoments>& other, std::vector<FaceMoments>& sums);

}  // namespace bodyline::optimize
