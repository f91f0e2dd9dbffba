#include "optimize/scan_fit_target.hpp"

#include <cmath>
#include <stdexcept>

#include "optimize/folded_scan.hpp"
#include "optimize/quantile.hpp"
#include "optimize/rim_pulls.hpp"
#include "optimize/scan_follow.hpp"
#include "optimize/scan_match.hpp"
#include "optimize/scan_term.hpp"

namespace bodyline::optimize {
namespace {

constexpr double heeded_share = 0.9;
constexpr int rounds_per_search = 2;  // points change their faces only then
constexpr int following_steps = 3;

class ScanFitTarget : public FitTarget {
 public:
  ScanFitTarget(const model::BodyPlan& plan, model::Stage stage,
                std::shared_ptr<const model::Scan> scan)
      : scan_(std::move(scan)),
        matcher_(plan, stage, *scan_),
        puller_(plan, stage, *scan_),
        kernels_(&model::kernels(model::best_isa())),
        faces_(&plan.faces(stage)),
        follower_(plan, stage, *scan_, rims_of(plan, stage)),
        term_(std::make_shared<ScanTerm>(plan, stage)) {}

  void match(const double* nets, const FitRound& round) override;
  model::WeightedNetTerm term() const override { return {term_, 1.0}; }
  std::string name() const override { return "scan"; }
  double distance() const override { return distance_; }
  double misfit() const override { return misfit_; }

 private:
  std::shared_ptr<const model::Scan> scan_;
  ScanMatcher matcher_;
  RimPuller puller_;
  const model::Kernels* kernels_;
  const std::vector<model::Face>* faces_;
  ScanFollower follower_;
  std::shared_ptr<ScanTerm> term_;
  int rounds_ = 0;
  double distance_ = 0.0, misfit_ = 0.0;
};

void ScanFitTarget::match(const double* nets, const FitRound& round) {
  const bool anew = rounds_++ % rounds_per_search == 0;
  if (anew) follower_.start(matcher_.match(nets));
  std::vector<FaceMoments> moments =
      follower_.follow(nets, round.reach, anew ? 0 : following_steps);
  misfit_ = trimmed_rms(follower_.distances(), heeded_share);
  distance_ = quantile(follower_.distances(), 0.5);
  std::vector<Match> rim_matches;
  std::vector<MatchPull> rim_pulls;
  puller_.append(nets, round.reach.rim, round.rims * double(scan_->points.size()), rim_matches,
                 rim_pulls);
  merge_moments(collect_moments(*faces_, *kernels_, rim_matches, rim_pulls), moments);
  term_->set(moments);
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
