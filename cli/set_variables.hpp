#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/variables.hpp"

namespace bodyline::cli {

/// How an assignment makes a new number of an old one.
enum class AssignmentKind { replace, add, multiply };

/// NAME=VALUE as the user wrote it.
struct Assignment {
  std::string text;     ///< all of it, for messages
  std::string pattern;  ///< which parameters
  AssignmentKind kind = AssignmentKind::replace;
  double number = 0.0;
};

/// Reads "NAME=0.1", "NAME+=5", "NAME-=5" (add) or "NAME=*1.5" (multiply). Throws
/// std::invalid_argument for anything else.
Assignment assignment_from_text(const std::string& text);

/// Carries out one assignment on all parameters that its pattern matches, with everything that is
/// tied to them, and returns the variables that were set. Fixed parameters are skipped when the
/// pattern matches others too. Throws std::invalid_argument when nothing matches, when all that
/// matches is fixed, and when two parameters that are tied would get numbers that contradict.
std::vector<int> assign(const model::VariableMap& map, const Assignment& assignment,
                        Eigen::VectorXd& parameters);

}  // namespace bodyline::cli
