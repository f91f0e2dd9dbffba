#include "cli/set_variables.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>

#include "model/selection.hpp"
#include "model/suggest.hpp"

namespace bodyline::cli {
namespace {

double number_from_text(const std::string& number, const std::string& assignment) {
  double value = 0.0;
  const char* begin = number.data();
  const char* const end = begin + number.size();
  if (begin != end && *begin == '+') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) {
    throw std::invalid_argument(
        fmt::format("'{}' in '{}' is not a finite number", number, assignment));
  }
  return value;
}

double assigned(const Assignment& assignment, double old) {
  switch (assignment.kind) {
    case AssignmentKind::add:
      return old + assignment.number;
    case AssignmentKind::multiply:
      return old * assignment.number;
    case AssignmentKind::replace:
      break;
  }
  return assignment.number;
}

std::vector<int> matching_parameters(const model::VariableMap& map, const Assignment& assignment) {
  std::vector<int> moving;
  bool any = false;
  for (int k = 0; k < map.layout().size(); ++k) {
    if (!model::name_matches(assignment.pattern, map.parameter_names()[k])) continue;
    any = true;
    if (map.variable_of(k) >= 0) moving.push_back(k);
  }
  if (!any) {
    throw std::invalid_argument(
        fmt::format("no variable matches '{}'; the nearest name is '{}'", assignment.pattern,
                    model::nearest_name(assignment.pattern, map.parameter_names())));
  }
  if (moving.empty()) {
    throw std::invalid_argument(fmt::format(
        "'{}' is fixed: a cut on a free or uncut side, a point on the plane of symmetry, or a "
        "lean that this joint cannot have",
        assignment.pattern));
  }
  return moving;
}

// A parameter that gets a number, and the value of its variable that this needs.
struct Demand {
  int parameter = -1;
  double number = 0.0, variable_value = 0.0;
};

const model::Tie& tie_of(const model::VariableMap& map, int parameter) {
  for (const model::Tie& tie : map.variables()[map.variable_of(parameter)].ties) {
    if (tie.parameter == parameter) return tie;
  }
  throw std::logic_error("a variable does not know its parameter");
}

// Equal but for the rounding of the offsets of ties.
bool agree(double a, double b) {
  constexpr double rounding = 1e-12;
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

}  // namespace

Assignment assignment_from_text(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw std::invalid_argument("'" + text + "' is not of the form NAME=VALUE");
  }
  Assignment assignment;
  assignment.text = text;
  assignment.pattern = text.substr(0, equals);
  std::string number = text.substr(equals + 1);
  const char last = assignment.pattern.back();
  if (last == '+' || last == '-') {
    assignment.pattern.pop_back();
    assignment.kind = AssignmentKind::add;
  } else if (number.starts_with('*')) {
    number.erase(0, 1);
    assignment.kind = AssignmentKind::multiply;
  }
  assignment.number = number_from_text(number, text);
  if (last == '-') assignment.number = -assignment.number;
  return assignment;
}

std::vector<int> assign(const model::VariableMap& map, const Assignment& assignment,
                        Eigen::VectorXd& parameters) {
  std::map<int, Demand> demands;  // by variable
  for (const int parameter : matching_parameters(map, assignment)) {
    const model::Tie& tie = tie_of(map, parameter);
    const double number = assigned(assignment, parameters[parameter]);
    const double value = (number - tie.offset) / tie.factor;
    const auto [known, is_new] =
        demands.try_emplace(map.variable_of(parameter), Demand{parameter, number, value});
    if (is_new || agree(known->second.variable_value, value)) continue;
    throw std::invalid_argument(fmt::format(
        "'{}' asks of {} and {}, which move together, what contradicts; set one of them",
        assignment.text, map.parameter_names()[known->second.parameter],
        map.parameter_names()[parameter]));
  }
  std::vector<int> variables;
  for (const auto& [variable, demand] : demands) {
    model::Selection(map, {variable})
        .scatter(Eigen::VectorXd::Constant(1, demand.variable_value), parameters);
    parameters[demand.parameter] = demand.number;  // the offset of a tie may have cost a bit
    variables.push_back(variable);
  }
  return variables;
}

}  // namespace bodyline::cli
