#include "optimize/robust_pulls.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

double geman_mcclure(double distance, double reach) {
  const double q = distance / reach, root = 1.0 / (1.0 + q * q);
  return root * root;
}

bool on_rim(const Match& match, const std::array<bool, 4>& rims) {
  return (rims[0] && match.u <= 0.0) || (rims[1] && match.u >= 1.0) ||
         (rims[2] && match.v <= 0.0) || (rims[3] && match.v >= 1.0);
}

}  // namespace

std::vector<MatchPull> robust_pulls(const std::vector<Match>& matches, const model::Scan& scan,
                                    const std::vector<std::array<bool, 4>>& rims,
                                    const PullReach& reach) {
  std::vector<MatchPull> pulls;
  pulls.reserve(matches.size());
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const Match& match = matches[k];
    const Vector3d offset = scan.points[k] - match.foot;
    const double off = offset.dot(match.normal);
    const Vector3d along = offset - off * match.normal;
    const double beyond = along.norm();
    const bool at_rim = on_rim(match, rims[match.face]);
    // Beside an inner edge the other face has the point; there the whole distance counts.
    double weight = geman_mcclure(at_rim ? off : match.distance, reach.normal);
    if (!scan.normals.empty()) {
      const double cosine = std::max(0.0, match.normal.dot(scan.normals[k]));
      weight *= cosine * cosine;
    }
    Eigen::Matrix3d pull = match.normal * match.normal.transpose();
    if (at_rim && beyond > 0.0) {
      const double rim_weight = geman_mcclure(beyond, reach.rim);
      weight *= rim_weight;
      pull += along * along.transpose() / (beyond * beyond);
    }
    pulls.push_back({scan.points[k], weight * pull});
  }
  return pulls;
}

}  // namespace bodyline::optimize
