#pragma once

#include <string>
#include <vector>

#include "optimize/chain_objective.hpp"
#include "optimize/minimize.hpp"

namespace bodyline::optimize {

/// Which variables of a chain are tuned, and how they are sought. The defaults tune what the papers
/// leave as future work: the shape parameters, and the constants of the joins.
struct ChainTuningOptions {
  std::vector<std::string> vary{"shape.*", "ratio.*", "slide.*"};  ///< patterns of variables
  std::vector<std::string> hold;                                   ///< patterns to freeze
  Options search;
};

/// What tuning did.
struct ChainTuning {
  Status status = Status::failed;
  double start_measure = 0.0, end_measure = 0.0;  ///< ChainObjective::measure
  std::vector<std::string> variables;
  Eigen::VectorXd start_values, end_values;
  int evaluations = 0;
  double seconds = 0.0;
  double gradient_norm = 0.0;
};

/// Those of a chain's variables that are to be tuned. Throws std::invalid_argument for patterns
/// that match nothing or hold everything.
std::vector<model::ChainVariable> chosen_variables(std::vector<model::ChainVariable> variables,
                                                   const ChainTuningOptions& options);

ChainTuning tune(ChainObjective& problem, const Options& search);

}  // namespace bodyline::optimize
