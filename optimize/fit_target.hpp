#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/body_plan.hpp"
#include "model/kernels.hpp"
#include "model/net_term.hpp"
#include "optimize/pull_reach.hpp"

namespace bodyline::optimize {

/// How much a round of a fit heeds and forbids.
struct FitRound {
  /// Points may change their faces; otherwise they stay on those of the match before and follow.
  bool search_anew = true;
  PullReach reach;
  double fold_weight = 0.0;
  model::FoldOptions fold;
  int nodes = 8;       ///< Gauss nodes per direction on a face
  double rims = 0.0;   ///< weight of the body's rims, see FitOptions
  double edges = 0.0;  ///< and of the target's edges
};

/// Distances of a target's points from the body, mm.
struct TargetFit {
  double median = 0.0;
  double misfit = 0.0;  ///< root mean square of the nearest nine tenths
};

/// The same of distances without sign.
TargetFit target_fit(const std::vector<double>& distances);

/// Something that a body is fitted to: a scan, an outline, a dimension. Each round of a fit matches
/// it anew with the body as it then is; between two matches it is a term of the search.
class FitTarget {
 public:
  virtual ~FitTarget() = default;

  /// Matches it with the body of these nets (xyz at the plan's offsets), built to the stage that it
  /// was made for. The same nets and a search anew give the same match, whatever came before.
  virtual void match(const double* nets, const FitRound& round) = 0;

  /// Called once in a round, between its match and its search: what the round before left over may
  /// change the term.
  virtual void advance() {}

  /// The term as of the last match, in mm^2.
  virtual model::WeightedNetTerm term() const = 0;

  /// Distances at the last match; nothing where the target is not points.
  virtual std::optional<TargetFit> fit() const { return std::nullopt; }
  /// How far the body is out of the worst of the target's bounds at the last match, mm; NaN where
  /// that cannot be told.
  virtual double excess() const { return 0.0; }
};

/// How closely a phase of a fit looks at its targets.
enum class FitDetail { coarse, fine };

/// Makes a target for a phase of a fit. What it makes may keep references to the plan, which
/// outlives it.
using FitTargetMaker =
    std::function<std::unique_ptr<FitTarget>(const model::BodyPlan&, model::Stage, FitDetail)>;

}  // namespace bodyline::optimize
