#pragma once

#include <map>
#include <utility>
#include <vector>

#include "model/face_rule.hpp"
#include "model/kernels.hpp"
#include "model/patch_chain.hpp"
#include "optimize/chain_objective.hpp"

namespace bodyline::optimize {

struct ChainProblemOptions {
  double bending = 1.0;  ///< weight of the bending energy of all patches
  double fold = 100.0;   ///< weight of the barrier against folds
  double within = 10.0;  ///< how far each coordinate of a free control point may move, mm; positive
  int nodes = 16;        ///< Gauss nodes per direction on each patch
  model::FoldOptions fold_options;
  model::Isa isa = model::best_isa();
};

/// Fairness of a chain of joined patches over some of its variables. The rows that the joins
/// determine are computed again for every x, so that the joins hold exactly throughout. Patches
/// that are no polynomials are summed over their Bezier forms (model/bezier_form.hpp).
class ChainProblem : public ChainObjective {
 public:
  /// Throws std::invalid_argument as model::propagate, and when a patch has no Bezier form.
  ChainProblem(const model::PatchChain& chain, std::vector<model::ChainVariable> variables,
               const ChainProblemOptions& options);

  /// Not finite where shape parameters leave a row undefined.
  double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) override;

  /// The propagated chain at x. Throws as model::propagate.
  model::PatchChain chain_at(const Eigen::VectorXd& x) const;
  /// Bending energy of all patches, unweighted, at the last x.
  double measure() const override { return bending_; }

 private:
  double patch_value(const model::FamilyPatch& patch, model::FamilyPatchBar* bar);

  model::PatchChain chain_;
  model::ChainLayout layout_;
  ChainProblemOptions options_;
  std::map<std::pair<int, int>, model::FaceTables> tables_;  // by the degrees of the Bezier forms
  double bending_ = 0.0;
};

}  // namespace bodyline::optimize
