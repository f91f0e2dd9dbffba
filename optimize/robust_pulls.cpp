#include "optimize/robust_pulls.hpp"

namespace bodyline::optimize {

std::vector<MatchPull> robust_pulls(const std::vector<Match>& matches, const model::Scan& scan,
                                    double scale) {
  std::vector<MatchPull> pulls;
  pulls.reserve(matches.size());
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const Match& match = matches[k];
    const double q = match.distance / scale, root = 1.0 / (1.0 + q * q);
    double weight = root * root;
    if (!scan.normals.empty()) {
      const double cosine = std::max(0.0, match.normal.dot(scan.normals[k]));
      weight *= cosine * cosine;
    }
    pulls.push_back({scan.points[k], weight * match.normal * match.normal.transpose()});
  }
  return pulls;
}

}  // namespace bodyline::optimize
