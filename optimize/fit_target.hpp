#pragma once

#include <functional>
#include <memory>
#include <string>

#include "model/body_plan.hpp"
#include "model/kernels.hpp"
#include "model/net_term.hpp"
#include "optimize/robust_pulls.hpp"

namespace bodyline::optimize {

/// How much a round of a fit heeds and forbids.
struct FitRound {
  PullReach reach;
  double fold_weight = 0.0;
  model::FoldOptions fold;
  int nodes = 8;      ///< Gauss nodes per direction on a face
  double rims = 0.0;  ///< weight of the body's rims, see FitOptions
};

/// Something that a body is fitted to: a scan, an outline, a dimension. Each round of a fit matches
/// it anew with the body as it then is; between two matches it is a term of the search.
class FitTarget {
 public:
  virtual ~FitTarget() = default;

  /// Matches it with the body of these nets (xyz at the plan's offsets), built to the stage that it
  /// was made for.
  virtual void match(const double* nets, const FitRound& round) = 0;

  /// The term as of the last match, in mm^2.
  virtual model::WeightedNetTerm term() const = 0;

  /// What it is, in a word or two; its median distance at the last match, mm; and how badly the
  /// body meets all that it can meet of it: the root mean square of the nearest nine tenths, mm.
  virtual std::string name() const = 0;
  virtual double distance() const = 0;
  virtual double misfit() const = 0;
};

/// How closely a phase of a fit looks at its targets.
enum class FitDetail { coarse, fine };

/// Makes a target for a phase of a fit. What it makes may keep references to the plan, which
/// outlives it.
using FitTargetMaker =
    std::function<std::unique_ptr<FitTarget>(const model::BodyPlan&, model::Stage, FitDetail)>;

}  // namespace bodyline::optimize
