#include "optimize/scan_fit_target.hpp"

#include <cmath>
#include <stdexcept>

#include "optimize/folded_scan.hpp"
#include "optimize/quantile.hpp"
#include "optimize/rim_pulls.hpp"
#include "optimize/scan_match.hpp"
#include "optimize/scan_term.hpp"

namespace bodyline::optimize {
namespace {

class ScanFitTarget : public FitTarget {
 public:
  ScanFitTarget(const model::BodyPlan& plan, model::Stage stage,
                std::shared_ptr<const model::Scan> scan)
      : scan_(std::move(scan)),
        matcher_(plan, stage, *scan_),
        puller_(plan, stage, *scan_),
        rims_(rims_of(plan, stage)),
        term_(std::make_shared<ScanTerm>(plan, stage)) {}

  void match(const double* nets, const FitRound& round) override;
  model::WeightedNetTerm term() const override { return {term_, 1.0}; }
  std::string name() const override { return "scan"; }
  double distance() const override { return distance_; }

 private:
  std::shared_ptr<const model::Scan> scan_;
  ScanMatcher matcher_;
  RimPuller puller_;
  std::vector<std::array<bool, 4>> rims_;
  std::shared_ptr<ScanTerm> term_;
  double distance_ = 0.0;
};

void ScanFitTarget::match(const double* nets, const FitRound& round) {
  std::vector<Match> matches = matcher_.match(nets);
  std::vector<double> distances;
  for (const Match& match : matches) distances.push_back(std::abs(match.distance));
  distance_ = quantile(std::move(distances), 0.5);
  std::vector<MatchPull> pulls = robust_pulls(matches, *scan_, rims_, round.reach);
  puller_.append(nets, round.reach.rim, round.rims * double(scan_->points.size()), matches, pulls);
  term_->set(matches, pulls);
}

}  // namespace

FitTargetMaker scan_fit_target(const model::Scan& scan, const model::Pose& pose,
                               std::size_t coarse_points, std::size_t fine_points) {
  if (scan.points.empty()) throw std::invalid_argument("the scan has no points");
  if (scan.normals.size() != scan.points.size())
    throw std::invalid_argument("the scan has no normals; estimate them first");
  if (coarse_points < 1 || fine_points < 1)
    throw std::invalid_argument("numbers of points of a fit must be positive");
  const auto coarse = std::make_shared<model::Scan>(folded_scan(scan, pose, coarse_points));
  const auto fine = std::make_shared<model::Scan>(folded_scan(scan, pose, fine_points));
  return [coarse, fine](const model::BodyPlan& plan, model::Stage stage, FitDetail detail) {
    return std::make_unique<ScanFitTarget>(plan, stage,
                                           detail == FitDetail::coarse ? coarse : fine);
  };
}

}  // namespace bodyline::optimize
