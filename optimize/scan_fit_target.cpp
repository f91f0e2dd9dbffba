#include "optimize/scan_fit_target.hpp"

#include <cmath>
#include <stdexcept>

#include "optimize/folded_scan.hpp"
#include "optimize/pull_term.hpp"
#include "optimize/rim_pulls.hpp"
#include "optimize/scan_edges.hpp"
#include "optimize/scan_follow.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {
namespace {

constexpr int following_steps = 3;
// Rims look so many times farther for where the scan ends than its points look for rims.
constexpr double rims_look = 2.0;

class ScanFitTarget : public FitTarget {
 public:
  ScanFitTarget(const model::BodyPlan& plan, model::Stage stage,
                std::shared_ptr<const model::Scan> scan,
                std::shared_ptr<const std::vector<ScanEdge>> edges)
      : scan_(std::move(scan)),
        edges_(std::move(edges)),
        matcher_(plan, stage, *scan_),
        puller_(plan, stage, *scan_, *edges_),
        kernels_(&model::kernels(model::best_isa())),
        faces_(&plan.faces(stage)),
        follower_(plan, stage, *scan_, rims_of(plan, stage)),
        term_(std::make_shared<PullTerm>(plan, stage)) {}

  void match(const double* nets, const FitRound& round) override;
  model::WeightedNetTerm term() const override { return {term_, 1.0}; }
  std::optional<TargetFit> fit() const override { return target_fit(follower_.distances()); }

 private:
  std::shared_ptr<const model::Scan> scan_;
  std::shared_ptr<const std::vector<ScanEdge>> edges_;
  ScanMatcher matcher_;
  RimPuller puller_;
  const model::Kernels* kernels_;
  const std::vector<model::Face>* faces_;
  ScanFollower follower_;
  std::shared_ptr<PullTerm> term_;
};

void ScanFitTarget::match(const double* nets, const FitRound& round) {
  const bool anew = round.search_anew || follower_.distances().empty();
  if (anew) follower_.start(matcher_.match(nets));
  std::vector<FaceMoments> moments =
      follower_.follow(nets, round.reach, anew ? 0 : following_steps);
  std::vector<Match> rim_matches;
  std::vector<MatchPull> rim_pulls;
  const double count = double(scan_->points.size());
  puller_.append(nets, {rims_look * round.reach.rim, round.rims * count, round.edges * count},
                 rim_matches, rim_pulls);
  merge_moments(collect_moments(*faces_, *kernels_, rim_matches, rim_pulls), moments);
  term_->set(moments);
}

}  // namespace

FitTargetMaker scan_fit_target(const model::Scan& scan, const model::Pose& pose,
                               const ScanFitOptions& options) {
  if (scan.points.empty()) throw std::invalid_argument("the scan has no points");
  if (scan.normals.size() != scan.points.size())
    throw std::invalid_argument("the scan has no normals; estimate them first");
  if (options.coarse_points < 1 || options.fine_points < 1 || options.edge_points < 1)
    throw std::invalid_argument("coarse_points, fine_points and edge_points must be positive");
  const auto coarse =
      std::make_shared<model::Scan>(folded_scan(scan, pose, options.coarse_points).scan);
  const auto fine =
      std::make_shared<model::Scan>(folded_scan(scan, pose, options.fine_points).scan);
  const auto edges = std::make_shared<std::vector<ScanEdge>>(
      scan_edges(folded_scan(scan, pose, options.edge_points).scan));
  const auto none = std::make_shared<std::vector<ScanEdge>>();
  return [=](const model::BodyPlan& plan, model::Stage stage, FitDetail detail) {
    return std::make_unique<ScanFitTarget>(plan, stage, detail == FitDetail::coarse ? coarse : fine,
                                           stage == model::Stage::base ? none : edges);
  };
}

}  // namespace bodyline::optimize
