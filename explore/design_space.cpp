#include "explore/design_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "explore/same_structure.hpp"
#include "explore/study_error.hpp"
#include "model/selection.hpp"

namespace bodyline::explore {
namespace {

using model::ParameterKind;
using model::Variable;

constexpr double steps = 4294967296.0;  // 2^32, of a column's range or more
const char* const names[] = {"value", "offset", "factor", "weight", "choice"};

double round_to(double value, double step) { return std::nearbyint(value / step) * step; }

// Both ends are reached exactly.
double value_at(const Column& column, double coordinate) {
  if (coordinate <= 0.0) return column.lower;
  if (coordinate >= 1.0) return column.upper;
  const double value =
      round_to(column.lower + coordinate * (column.upper - column.lower), column.step);
  return std::clamp(value, column.lower, column.upper);
}

double coordinate_of(const Column& column, double value) {
  return std::clamp((value - column.lower) / (column.upper - column.lower), 0.0, 1.0);
}

// What is left of a simplex of `count` weights is broken off evenly: the share that the first of
// them takes, for a uniform coordinate.
double broken_share(double coordinate, int count) {
  return count == 2 ? coordinate : 1.0 - std::pow(1.0 - coordinate, 1.0 / (count - 1));
}

double coordinate_of_share(double share, int count) {
  return count == 2 ? share : 1.0 - std::pow(1.0 - share, double(count - 1));
}

bool is_upper_cut(const model::VariableMap& map, const Variable& variable) {
  return (variable.ties.front().parameter - map.layout().cut(0)) % 2 == 1;
}

// Offsets and factors can be so small that they leave nothing of a range, and so large that they
// leave no number.
void check_range(const Column& column) {
  if (column.lower < column.upper && std::isfinite(column.upper - column.lower)) return;
  throw StudyError("variables", "gives \"" + column.name + "\" a range from " +
                                    fmt::format("{} to {}", column.lower, column.upper) +
                                    "; it must be wider than rounding, and finite");
}

std::string unit_of(const Variable& variable) {
  return variable.kind == ParameterKind::curve ? "mm" : "1";
}

}  // namespace

const char* column_kind_name(ColumnKind kind) { return names[int(kind)]; }

DesignSpace::DesignSpace(const Study& study) {
  if (study.models.empty()) throw StudyError("model", "names no model");
  for (const BaseModel& base : study.models) models_.push_back(base.model);
  context_ = std::make_shared<model::BodyContext>(models_.front());
  if (study.base != BaseKind::model) add_bases(study);
  for (const VariableGroup& group : study.variables) add_group(group);
  if (columns_.empty()) throw StudyError("variables", "is empty; something must vary");
  dimension_ = column_count() - (weights_ > 0 ? 1 : 0);
  for (const Column& column : columns_) {
    for (const Column& other : columns_) {
      if (&column < &other && column.name == other.name)
        throw StudyError("variables", "gives two variables the name \"" + column.name + "\"");
    }
  }
  for (Column& column : columns_) {
    check_range(column);
    column.step = std::exp2(std::ceil(std::log2(column.upper - column.lower))) / steps;
  }
  gather_bases();
}

// The columns of a choice or a blend, which move everything.
void DesignSpace::add_bases(const Study& study) {
  const bool blend = study.base == BaseKind::blend;
  const std::string key = blend ? "blend" : "choice";
  for (const BaseModel& base : study.models) {
    const std::string found = structural_difference(study.models.front().model, base.model);
    if (found.empty()) continue;
    throw StudyError(key, "needs models that differ in nothing but their numbers; \"" + base.name +
                              "\" differs from \"" + study.models.front().name + "\" in " + found);
  }
  for (int k = 0; k < context_->map.count(); ++k) moved_.push_back(k);
  if (!blend) {
    choice_ = true;
    columns_.push_back({"model", "1", ColumnKind::choice, 0.0, double(models_.size() - 1), 0.0});
    return;
  }
  for (const BaseModel& base : study.models) {
    const double start = columns_.empty() ? 1.0 : 0.0;
    columns_.push_back({"weight." + base.name, "1", ColumnKind::weight, 0.0, 1.0, start});
  }
  weights_ = int(columns_.size());
}

// The place of a variable of the body among those that move.
int DesignSpace::moving(int variable) {
  const auto found = std::find(moved_.begin(), moved_.end(), variable);
  if (found != moved_.end()) return int(found - moved_.begin());
  moved_.push_back(variable);
  return int(moved_.size()) - 1;
}

void DesignSpace::add_group(const VariableGroup& group) {
  const std::string key = "variables." + group.name;
  const auto select = [&](const std::string& pattern) {
    try {
      return context_->map.select(std::vector<std::string>{pattern});
    } catch (const std::invalid_argument& error) {
      throw StudyError(key + ".vary", error.what());
    }
  };
  std::map<int, double> weights;  // of the variables that the group moves, in their order
  for (std::size_t p = 0; p < group.vary.size(); ++p) {
    for (const int variable : select(group.vary[p]))
      weights.emplace(variable, group.weights.empty() ? 1.0 : group.weights[p]);
  }
  for (const auto& [variable, weight] : weights) {
    if (const auto [owner, is_new] = owner_.emplace(variable, group.name); !is_new) {
      throw StudyError(key + ".vary", "moves " + context_->map.variables()[variable].name +
                                          ", which \"" + owner->second + "\" moves already");
    }
  }
  if (group.linked) {
    const bool offset = group.kind == RangeKind::offset;
    const std::string unit =
        offset ? unit_of(context_->map.variables()[weights.begin()->first]) : "1";
    columns_.push_back({group.name, unit, offset ? ColumnKind::offset : ColumnKind::factor,
                        group.range[0], group.range[1], offset ? 0.0 : 1.0});
  }
  for (const auto& [variable, weight] : weights) {
    if (!group.linked) columns_.push_back(own_column(group, variable));
    moves_.push_back({column_count() - 1, moving(variable), weight});
  }
}

// The column of one variable of a group that is not linked.
Column DesignSpace::own_column(const VariableGroup& group, int index) const {
  const std::string key = "variables." + group.name;
  const Variable& variable = context_->map.variables()[index];
  const double start = context_->parameters[variable.ties.front().parameter];
  Column column{variable.name,  unit_of(variable), ColumnKind::value,
                group.range[0], group.range[1],    start};
  const bool one_model = models_.size() == 1;
  switch (group.kind) {
    case RangeKind::bounds:
      if (!std::isfinite(variable.lower) || !std::isfinite(variable.upper)) {
        throw StudyError(key, "needs a range: " + variable.name + " has no bounds of its own");
      }
      column.lower = variable.lower;
      column.upper = variable.upper;
      break;
    case RangeKind::value:
      break;
    case RangeKind::offset:
      if (one_model) {
        column.lower += start;
        column.upper += start;
      } else {
        column.kind = ColumnKind::offset;
        column.start = 0.0;
      }
      break;
    case RangeKind::factor:
      if (one_model) {
        if (start == 0.0)
          throw StudyError(key + ".factor", "leaves " + variable.name + " at 0; give an offset");
        column.lower = std::min(group.range[0] * start, group.range[1] * start);
        column.upper = std::max(group.range[0] * start, group.range[1] * start);
      } else {
        column.kind = ColumnKind::factor;
        column.unit = "1";
        column.start = 1.0;
      }
      break;
    case RangeKind::width:
      if (variable.kind != ParameterKind::cut)
        throw StudyError(key + ".width", "is for cuts, and " + variable.name + " is none");
      if (is_upper_cut(context_->map, variable)) {
        column.lower = 1.0 - group.range[1];
        column.upper = 1.0 - group.range[0];
      }
      break;
  }
  return column;
}

void DesignSpace::gather_bases() {
  bases_.resize(Eigen::Index(moved_.size()), Eigen::Index(models_.size()));
  const model::Selection selection(context_->map, moved_);
  for (std::size_t m = 0; m < models_.size(); ++m)
    bases_.col(m) = selection.gather(model::to_parameters(models_[m], context_->map.layout()));
}

std::vector<double> DesignSpace::start_values() const {
  std::vector<double> values;
  for (const Column& column : columns_) values.push_back(column.start);
  return values;
}

std::vector<double> DesignSpace::start_point() const {
  std::vector<double> result(std::size_t(dimension_), 0.0);
  point(start_values(), result);
  return result;
}

void DesignSpace::values(std::span<const double> point, std::span<double> values) const {
  double rest = 1.0;
  for (int k = 0; k + 1 < weights_; ++k) {
    values[k] = round_to(rest * broken_share(point[k], weights_ - k), 1.0 / steps);
    rest -= values[k];
  }
  if (weights_ > 0) values[weights_ - 1] = rest;
  if (choice_) {
    const int count = int(models_.size());
    values[0] = std::clamp(std::floor(point[0] * count), 0.0, count - 1.0);
  }
  const int skipped = column_count() - dimension_;
  for (int k = first_number(); k < column_count(); ++k)
    values[k] = value_at(columns_[k], point[k - skipped]);
}

void DesignSpace::point(std::span<const double> values, std::span<double> point) const {
  double rest = 1.0;
  for (int k = 0; k + 1 < weights_; ++k) {
    const double share = rest > 0.0 ? std::clamp(values[k] / rest, 0.0, 1.0) : 0.0;
    point[k] = coordinate_of_share(share, weights_ - k);
    rest -= values[k];
  }
  if (choice_) point[0] = (values[0] + 0.5) / double(models_.size());
  const int skipped = column_count() - dimension_;
  for (int k = first_number(); k < column_count(); ++k)
    point[k - skipped] = coordinate_of(columns_[k], values[k]);
}

void DesignSpace::base(std::span<const double> values, Eigen::VectorXd& x) const {
  x = bases_.col(choice_ ? Eigen::Index(values[0]) : 0);
  if (weights_ == 0) return;
  x *= values[0];
  for (int m = 1; m < weights_; ++m) x += values[m] * bases_.col(m);
}

void DesignSpace::body(std::span<const double> values, Eigen::VectorXd& x) const {
  base(values, x);
  for (const Move& move : moves_) {
    const double value = values[move.column];
    switch (columns_[move.column].kind) {
      case ColumnKind::value:
        x[move.variable] = value;
        break;
      case ColumnKind::offset:
        x[move.variable] += move.weight * value;
        break;
      default:
        x[move.variable] *= value;
    }
  }
}

void DesignSpace::body_pullback(std::span<const double> values, const Eigen::VectorXd& x_bar,
                                std::span<double> values_bar) const {
  std::fill(values_bar.begin(), values_bar.end(), 0.0);
  Eigen::VectorXd x, base_bar = x_bar;
  base(values, x);
  for (const Move& move : moves_) {
    const double bar = x_bar[move.variable];
    switch (columns_[move.column].kind) {
      case ColumnKind::value:
        values_bar[move.column] += bar;
        base_bar[move.variable] = 0.0;
        break;
      case ColumnKind::offset:
        values_bar[move.column] += move.weight * bar;
        break;
      default:
        values_bar[move.column] += x[move.variable] * bar;
        base_bar[move.variable] *= values[move.column];
    }
  }
  for (int m = 0; m < weights_; ++m) values_bar[m] = bases_.col(m).dot(base_bar);
}

model::Model DesignSpace::variant(std::span<const double> values, const std::string& name) const {
  Eigen::VectorXd x, parameters = context_->parameters;
  body(values, x);
  model::Selection(context_->map, moved_).scatter(x, parameters);
  model::Model model = models_.front();
  model.name = name;
  model.note.clear();
  for (model::Curve& curve : model.curves) curve.note.clear();
  for (model::Patch& patch : model.patches) patch.note.clear();
  for (model::Joint& joint : model.joints) joint.note.clear();
  model::set_parameters(model, context_->map.layout(), parameters);
  return model;
}

}  // namespace bodyline::explore
