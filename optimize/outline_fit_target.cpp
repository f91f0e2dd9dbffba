#include "optimize/outline_fit_target.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "optimize/outline_match.hpp"

namespace bodyline::optimize {
namespace {

using Outlines = std::vector<OutlineSamples>;

constexpr double coarse_spacing = 20.0, fine_spacing = 10.0;  // mm

class OutlineFitTarget : public FitTarget {
 public:
  OutlineFitTarget(const model::BodyPlan& plan, model::Stage stage,
                   std::shared_ptr<const Outlines> outlines, double weight)
      : plan_(&plan),
        stage_(stage),
        outlines_(std::move(outlines)),
        weight_(weight),
        term_(std::make_shared<PullTerm>(plan, stage)) {}

  void match(const double* nets, const FitRound& round) override;
  model::WeightedNetTerm term() const override { return {term_, weight_}; }
  std::optional<TargetFit> fit() const override { return fit_; }

 private:
  const model::BodyPlan* plan_;
  model::Stage stage_;
  std::shared_ptr<const Outlines> outlines_;
  double weight_;
  std::shared_ptr<PullTerm> term_;
  TargetFit fit_;
};

// Each once: front and rear share their silhouette.
std::vector<model::View> views_of(const Outlines& outlines) {
  std::vector<model::View> views;
  for (const OutlineSamples& outline : outlines) {
    if (std::find(views.begin(), views.end(), outline.view) == views.end())
      views.push_back(outline.view);
  }
  return views;
}

void OutlineFitTarget::match(const double* nets, const FitRound& round) {
  const model::SilhouetteBody body = model::silhouette_body(*plan_, stage_, nets);
  const Outlines& outlines = *outlines_;
  std::vector<OutlinePulls> found(outlines.size());
  const std::vector<model::View> views = views_of(outlines);
  tbb::parallel_for(std::size_t(0), views.size(), [&](std::size_t v) {
    model::SilhouetteOptions tracing;
    tracing.spacing = outlines.front().spacing;
    const auto pieces = model::silhouette(body, views[v], tracing);
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      if (outlines[k].view == views[v])
        found[k] = match_outline(body, pieces, outlines[k], {round.reach});
    }
  });
  OutlinePulls all;
  for (const OutlinePulls& one : found) {
    all.matches.insert(all.matches.end(), one.matches.begin(), one.matches.end());
    all.pulls.insert(all.pulls.end(), one.pulls.begin(), one.pulls.end());
    for (const double distance : one.distances) all.distances.push_back(std::abs(distance));
  }
  fit_ = target_fit(all.distances);
  term_->set(all.matches, all.pulls);
}

std::shared_ptr<const Outlines> sampled(const std::vector<model::PlacedDrawing>& drawings,
                                        double spacing) {
  auto outlines = std::make_shared<Outlines>();
  for (const model::PlacedDrawing& drawing : drawings)
    outlines->push_back(outline_samples(drawing, spacing));
  return outlines;
}

}  // namespace

FitTargetMaker outline_fit_target(const std::vector<model::PlacedDrawing>& drawings,
                                  double weight) {
  if (drawings.empty()) throw std::invalid_argument("no outline is given");
  const auto coarse = sampled(drawings, coarse_spacing), fine = sampled(drawings, fine_spacing);
  return [=](const model::BodyPlan& plan, model::Stage stage, FitDetail detail) {
    return std::make_unique<OutlineFitTarget>(plan, stage,
                                              detail == FitDetail::coarse ? coarse : fine, weight);
  };
}

}  // namespace bodyline::optimize
