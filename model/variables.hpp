#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "model/connect.hpp"
#include "model/name_matches.hpp"
#include "model/parameters.hpp"

/// The independent variables of a body. Parameters that mirror symmetry, shared curve ends or seams
/// tie together follow one variable: parameter = factor * variable + offset, with factor 1 or -1.
namespace bodyline::model {

/// One parameter that follows a variable.
struct Tie {
  int parameter = -1;
  double factor = 1.0;
  double offset = 0.0;
};

/// An independent variable, named after the first parameter it moves.
struct Variable {
  std::string name;
  ParameterKind kind = ParameterKind::curve;
  std::vector<Tie> ties;  ///< the first has factor 1 and offset 0
  double lower = 0.0,
         upper =
             0.0;  ///< the largest range in which a body may be sought; -inf, inf for curve points
};

/// How wide the bounds of VariableMap are. All are limits of the search, not of what a model file
/// may hold.
struct VariableBounds {
  double min_cut = 0.01;  ///< narrowest strip, as a fraction of the patch
  double max_cut = 0.1;   ///< widest strip
  double min_fullness = 0.3;
  double max_fullness = 2.7;
  double min_lean = 0.1;
  double max_lean = 1.5;
};

/// All independent variables of a model and how they move its parameters.
class VariableMap {
 public:
  VariableMap(const Model& model, const Connectivity& links, const VariableBounds& bounds = {});

  const ParameterLayout& layout() const { return layout_; }
  const std::vector<Variable>& variables() const { return variables_; }
  int count() const { return int(variables_.size()); }
  const std::vector<std::string>& parameter_names() const { return names_; }

  /// Variable that moves a parameter, or -1 when the parameter is fixed (a cut on a free side, y on
  /// the symmetry plane).
  int variable_of(int parameter) const { return owner_[parameter]; }

  /// Indices of the variables of which any parameter's name matches any pattern (`name_matches`),
  /// in order. A pattern that matches nothing throws std::invalid_argument, with the nearest name.
  std::vector<int> select(std::span<const std::string> patterns) const;

 private:
  ParameterLayout layout_;
  std::vector<std::string> names_;
  std::vector<Variable> variables_;
  std::vector<int> owner_;
};

}  // namespace bodyline::model
