#include "cli/variables_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/load_model.hpp"
#include "cli/print_json.hpp"
#include "model/evaluator.hpp"
#include "model/suggest.hpp"

namespace bodyline::cli {
namespace {

using model::ParameterKind;
using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<ParameterKind, const char*>, 5> kinds{
    {{ParameterKind::shape, "shape"},
     {ParameterKind::cut, "cut"},
     {ParameterKind::fullness, "fullness"},
     {ParameterKind::lean, "lean"},
     {ParameterKind::curve, "curve"}}};

const char* kind_name(ParameterKind kind) {
  for (const auto& [known, name] : kinds) {
    if (known == kind) return name;
  }
  return "";
}

struct Request {
  std::string model;
  std::vector<std::string> patterns;
  bool json = false, fixed = false;
};

// What is listed: variables, and parameters that no variable moves.
struct Listing {
  std::vector<int> variables;
  std::vector<int> fixed;
};

void refuse_idle_patterns(const model::VariableMap& map, const Request& request) {
  for (const std::string& pattern : request.patterns) {
    bool moves = false, matches = false;
    for (int k = 0; k < map.layout().size() && !moves; ++k) {
      if (!model::name_matches(pattern, map.parameter_names()[k])) continue;
      matches = true;
      moves = map.variable_of(k) >= 0;
    }
    if (moves || (matches && request.fixed)) continue;
    if (matches) {
      throw std::invalid_argument("what '" + pattern + "' matches is fixed; --fixed lists it");
    }
    throw std::invalid_argument("no variable matches '" + pattern + "'; the nearest name is '" +
                                model::nearest_name(pattern, map.parameter_names()) + "'");
  }
}

Listing listing(const model::VariableMap& map, const Request& request) {
  refuse_idle_patterns(map, request);
  Listing list;
  for (int k = 0; k < map.layout().size(); ++k) {
    if (!model::name_is_chosen(request.patterns, map.parameter_names()[k])) continue;
    if (const int variable = map.variable_of(k); variable >= 0) {
      list.variables.push_back(variable);
    } else if (request.fixed) {
      list.fixed.push_back(k);
    }
  }
  std::sort(list.variables.begin(), list.variables.end());
  list.variables.erase(std::unique(list.variables.begin(), list.variables.end()),
                       list.variables.end());
  return list;
}

int count_of(const model::VariableMap& map, const std::vector<int>& variables, ParameterKind kind) {
  return static_cast<int>(std::count_if(variables.begin(), variables.end(),
                                        [&](int k) { return map.variables()[k].kind == kind; }));
}

Json variable_json(const model::BodyContext& body, const model::Variable& variable) {
  Json ties = Json::array();
  for (std::size_t k = 1; k < variable.ties.size(); ++k) {
    const model::Tie& tie = variable.ties[k];
    ties.push_back({{"name", body.map.parameter_names()[tie.parameter]},
                    {"factor", tie.factor},
                    {"offset", tie.offset}});
  }
  return {{"name", variable.name},
          {"kind", kind_name(variable.kind)},
          {"value", body.parameters[variable.ties.front().parameter]},
          {"lower", variable.lower},
          {"upper", variable.upper},
          {"ties", ties}};
}

Json listing_json(const model::BodyContext& body, const Listing& list, const Request& request) {
  Json document{{"variables", Json::array()}};
  for (const int k : list.variables) {
    document["variables"].push_back(variable_json(body, body.map.variables()[k]));
  }
  if (request.fixed) {
    document["fixed"] = Json::array();
    for (const int k : list.fixed) {
      document["fixed"].push_back({{"name", body.map.parameter_names()[k]},
                                   {"kind", kind_name(body.map.layout().kind(k))},
                                   {"value", body.parameters[k]}});
    }
  }
  for (const auto& [kind, name] : kinds) {
    document["counts"][name] = count_of(body.map, list.variables, kind);
  }
  document["counts"]["total"] = list.variables.size();
  return document;
}

std::string tie_text(const model::BodyContext& body, const model::Variable& variable) {
  std::string text;
  for (std::size_t k = 1; k < variable.ties.size(); ++k) {
    const model::Tie& tie = variable.ties[k];
    text += (text.empty() ? "" : ", ") + std::string(tie.factor < 0.0 ? "-" : "") +
            body.map.parameter_names()[tie.parameter];
  }
  return text;
}

void print_table(Context& context, const model::BodyContext& body, const Listing& list) {
  std::size_t width = 8;
  for (const int k : list.variables) width = std::max(width, body.map.variables()[k].name.size());
  for (const int k : list.fixed) width = std::max(width, body.map.parameter_names()[k].size());
  std::string text = fmt::format("{:<{}}  {:>12}  {:>9}  {:>9}  moves with it\n", "variable", width,
                                 "value", "lower", "upper");
  for (const int k : list.variables) {
    const model::Variable& variable = body.map.variables()[k];
    text += fmt::format("{:<{}}  {:>12.8g}  {:>9.5g}  {:>9.5g}  {}\n", variable.name, width,
                        body.parameters[variable.ties.front().parameter], variable.lower,
                        variable.upper, tie_text(body, variable));
  }
  for (const int k : list.fixed) {
    text += fmt::format("{:<{}}  {:>12.8g}  {:>9}  {:>9}\n", body.map.parameter_names()[k], width,
                        body.parameters[k], "fixed", "");
  }
  *context.out << text;
}

void print_counts(Context& context, const model::VariableMap& map, const Listing& list) {
  std::string parts;
  for (const auto& [kind, name] : kinds) {
    const int count = count_of(map, list.variables, kind);
    if (count > 0) parts += fmt::format("{} {} {}", parts.empty() ? ":" : ",", count, name);
  }
  *context.out << fmt::format("\n{} of {} independent variables{}\n", list.variables.size(),
                              map.count(), parts);
}

void run(Context& context, const Request& request) {
  const model::BodyContext body(load_model(context, request.model));
  const Listing list = listing(body.map, request);
  if (request.json) {
    print_json(context, listing_json(body, list, request));
    return;
  }
  print_table(context, body, list);
  print_counts(context, body.map, list);
}

}  // namespace

void add_variables_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "variables", "List the design variables of a model",
                  "bodyline variables cars/model1.toml 'shape.hood.*' 'cut.hood.*'");
  add_model(*command, request->model);
  command
      ->add_option("PATTERN", request->patterns,
                   "Names to list, * and ? and [1-3] stand for others; all when left out")
      ->type_name("");
  command->add_flag("--fixed", request->fixed, "Numbers that cannot vary too");
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
