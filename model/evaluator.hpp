#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "model/body_plan.hpp"
#include "model/kernels.hpp"
#include "model/model.hpp"
#include "model/net_term.hpp"
#include "model/objective.hpp"
#include "model/variables.hpp"

namespace bodyline::model {

struct EvaluatorOptions {
  std::vector<Term> terms;                 ///< weighted sum to evaluate,
  std::vector<WeightedNetTerm> net_terms;  ///< with these added
  Stage stage = Stage::base;               ///< build at least so far, whatever the terms need
  int nodes = 8;    ///< Gauss nodes per direction on each face, a multiple of 8
  int threads = 1;  ///< within one evaluation; results have the same bits for any number
  FoldOptions fold;
  Isa isa = best_isa();
};

/// Everything about a body that evaluators share: made once per model, never changed afterwards.
struct BodyContext {
  BodyContext(const Model& model, const VariableBounds& bounds = {});
  BodyPlan plan;
  VariableMap map;
  Eigen::VectorXd parameters;  ///< of the model itself: the start
};

/// Design variables to objective and exact gradient. After construction no call allocates. With
/// threads > 1 each evaluator has threads of its own. One evaluator serves one thread at a time;
/// make one per thread for sweeps.
class Evaluator {
 public:
  /// `selected` are indices into context->map.variables(). Throws std::invalid_argument when a
  /// term's face pattern matches nothing or `nodes` is not allowed.
  Evaluator(std::shared_ptr<const BodyContext> context, std::vector<int> selected,
            EvaluatorOptions options);
  ~Evaluator();
  Evaluator(Evaluator&&) noexcept;
  Evaluator& operator=(Evaluator&&) noexcept;

  int size() const;  ///< number of selected variables
  const std::vector<int>& selected() const;
  const BodyContext& context() const;
  std::shared_ptr<const BodyContext> shared_context() const;
  const EvaluatorOptions& options() const;
  Eigen::VectorXd start() const;  ///< the model's own values of the selected variables

  /// Weighted sum of all terms at x; with a gradient (size() entries, overwritten) when not null.
  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* gradient);

  /// Unweighted values of the terms, in the order of options().terms, at the last x.
  const std::vector<double>& term_values() const;
  const std::vector<double>& net_term_values() const;  ///< likewise of options().net_terms

  /// The closeness to the model's own nets, as the term of that kind measures it.
  std::shared_ptr<NetTerm> closeness() const;

  /// All parameters and all nets (xyz, at the plan's offsets) at the last x.
  const Eigen::VectorXd& parameters() const;
  const double* nets() const;

  /// Only the stage variables -> nets, and its adjoint; for measurements and for terms outside this
  /// class.
  void build(const Eigen::VectorXd& x);
  /// The same from all parameters of the plan's layout, as a blend of models gives them.
  void build_parameters(const Eigen::VectorXd& parameters);
  void build_pullback(const std::vector<double>& nets_bar, Eigen::VectorXd& gradient);

 private:
  void require_size(const Eigen::VectorXd& x) const;

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::model
