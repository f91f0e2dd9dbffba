#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "explore/study.hpp"
#include "model/evaluator.hpp"

namespace bodyline::explore {

/// What the numbers of a column mean.
enum class ColumnKind {
  value,   ///< value of a variable of the body
  offset,  ///< added to the base's values
  factor,  ///< times the base's values
  weight,  ///< of a model in a blend; all weights add up to 1
  choice   ///< index into the study's models
};
const char* column_kind_name(ColumnKind kind);

/// One variable of a study: a column of `/variables`.
struct Column {
  std::string name;
  std::string unit;  ///< "mm" or "1"
  ColumnKind kind = ColumnKind::value;
  double lower = 0.0, upper = 0.0;
  double start = 0.0;  ///< where it is for the first model of the study
  double step = 0.0;   ///< values are multiples of it, but for both ends
};

/// The space that a study explores. Three vectors describe a variant: a point of the unit cube with
/// `dimension()` coordinates, as samplers make it; its values, one per column, as they are stored;
/// and the independent variables of the body that move, as an evaluator takes them. Never changed
/// after construction; safe to use from several threads.
class DesignSpace {
 public:
  /// Throws StudyError when a pattern matches nothing, models differ in what joins what, two groups
  /// move one variable, or a variable has no range.
  explicit DesignSpace(const Study& study);

  int dimension() const { return dimension_; }
  const std::vector<Column>& columns() const { return columns_; }
  int column_count() const { return int(columns_.size()); }
  const std::shared_ptr<const model::BodyContext>& context() const { return context_; }
  /// Independent variables of the body that move: indices into context()->map.variables().
  const std::vector<int>& body_variables() const { return moved_; }

  /// The first model's place in the cube, and its values.
  std::vector<double> start_point() const;
  std::vector<double> start_values() const;

  /// Every coordinate is rounded to one of 2^32 steps of its column's range. The weights of a blend
  /// are uniform on their simplex when the coordinates are uniform.
  void values(std::span<const double> point, std::span<double> values) const;
  /// An inverse of it, to the same rounding.
  void point(std::span<const double> values, std::span<double> point) const;

  void body(std::span<const double> values, Eigen::VectorXd& x) const;
  /// Adjoint of `body`: derivatives by the values from those by the body's variables. That by a
  /// choice is 0.
  void body_pullback(std::span<const double> values, const Eigen::VectorXd& x_bar,
                     std::span<double> values_bar) const;

  /// The variant as a model of its own, named `name`.
  model::Model variant(std::span<const double> values, const std::string& name) const;

 private:
  // What one column does to one of the body's moving variables.
  struct Move {
    int column = 0, variable = 0;  // position in moved_
    double weight = 1.0;
  };

  void add_bases(const Study& study);
  void add_group(const VariableGroup& group);
  Column own_column(const VariableGroup& group, int variable) const;
  int moving(int variable);
  void gather_bases();
  void base(std::span<const double> values, Eigen::VectorXd& x) const;
  int first_number() const { return choice_ ? 1 : weights_; }  // columns of the base before

  int dimension_ = 0;
  int weights_ = 0;  // columns of a blend, the first ones
  bool choice_ = false;
  std::vector<Column> columns_;
  std::vector<model::Model> models_;
  std::shared_ptr<const model::BodyContext> context_;
  std::vector<int> moved_;
  std::vector<Move> moves_;
  std::map<int, std::string> owner_;  // group of each variable of the body
  Eigen::MatrixXd bases_;             // of each model (columns), the moving variables
};

}  // namespace bodyline::explore
