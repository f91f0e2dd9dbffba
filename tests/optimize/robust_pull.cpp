#include "tests/optimize/robust_pull.hpp"

#include "optimize/geman_mcclure.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

bool on_rim(const Match& match, const std::array<bool, 4>& rims) {
  return (rims[0] && match.u <= 0.0) || (rims[1] && match.u >= 1.0) ||
         (rims[2] && match.v <= 0.0) || (rims[3] && match.v >= 1.0);
}

}  // namespace

MatchPull robust_pull(const Match& match, const Vector3d& point, const Vector3d* normal,
                      const std::array<bool, 4>& rims, const PullReach& reach,
                      double least_rim_cosine) {
  const Vector3d offset = point - match.foot;
  const double off = offset.dot(match.normal);
  const Vector3d along = offset - off * match.normal;
  const double beyond = along.norm();
  const bool at_rim = on_rim(match, rims);
  const double cosine = normal ? std::max(0.0, match.normal.dot(*normal)) : 1.0;
  // Beside an inner edge the other face has the point; there the whole distance counts.
  double weight =
      geman_mcclure(at_rim ? off * off : offset.squaredNorm(), reach.normal) * cosine * cosine;
  Eigen::Matrix3d pull = match.normal * match.normal.transpose();
  const bool at_end = (match.u <= 0.0 || match.u >= 1.0) && (match.v <= 0.0 || match.v >= 1.0);
  if (at_rim && at_end) weight = 0.0;
  if (at_rim && beyond > 0.0) {
    weight *= geman_mcclure(beyond * beyond, reach.rim);
    if (cosine < least_rim_cosine) weight = 0.0;
    pull += along * along.transpose() / (beyond * beyond);
  }
  return {point, weight * pull};
}

}  // namespace bodyline::optimize
