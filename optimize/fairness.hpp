#pragma once

#include <string>
#include <vector>

#include "model/evaluator.hpp"
#include "model/model.hpp"
#include "optimize/minimize.hpp"

namespace bodyline::optimize {

/// How a body is tuned. The defaults tune everything but the curves.
struct FairOptions {
  std::vector<std::string> vary{"shape.*", "cut.*", "fullness.*",
                                "lean.*"};  ///< patterns of variables
  std::vector<std::string> hold;            ///< patterns of variables to freeze
  std::vector<model::Term> terms{
      model::Term{}};          ///< what to minimize; the default is bending of the body
  double fold_weight = 100.0;  ///< of the barrier that keeps faces from folding; 0 leaves it out
  double within = 10.0;        ///< how far each coordinate of a curve point may move, mm
  model::VariableBounds bounds;
  int nodes = 16;         ///< Gauss nodes per direction on a face while searching
  int report_nodes = 24;  ///< of the values reported
  int threads = 1;        ///< within one evaluation
  Options search;
};

/// Value of an objective and of its terms, unweighted, for the whole body.
struct Measured {
  double value = 0.0;
  std::vector<double> terms;  ///< in the order of FairResult::terms
};

struct FairResult {
  Status status = Status::failed;
  model::Model model;              ///< the tuned model; the given one when nothing better was found
  std::vector<model::Term> terms;  ///< those of the options and the fold barriers
  Measured start, end;  ///< by report_nodes; end.value <= start.value unless fewer faces fold
  std::vector<std::string> variables;  ///< names of the varied variables
  Eigen::VectorXd start_values, end_values;
  Eigen::VectorXd lower, upper;  ///< their bounds
  int evaluations = 0;
  double seconds = 0.0;
  double gradient_norm = 0.0;
  std::vector<Progress> history;
  std::vector<std::string>
      folded_faces;  ///< faces that still fold; " (whole patch)" marks patches before their cut
};

/// Tunes the chosen variables of a model until the weighted terms are as small as they get. A body
/// that starts folded is unfolded first, since the energies are singular across a fold. Throws
/// model::ModelError for a model that cannot be built and std::invalid_argument for patterns that
/// match nothing or options that make no sense.
FairResult fair(const model::Model& model, const FairOptions& options);

}  // namespace bodyline::optimize
