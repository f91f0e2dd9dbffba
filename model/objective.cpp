#include "model/objective.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace bodyline::model {
namespace {

constexpr std::array<std::pair<TermKind, const char*>, 5> names{
    {{TermKind::bending, "bending"},
     {TermKind::variation, "variation"},
     {TermKind::area, "area"},
     {TermKind::fold, "fold"},
     {TermKind::closeness, "closeness"}}};

}  // namespace

std::string term_name(TermKind kind) {
  for (const auto& [known, name] : names) {
    if (known == kind) return name;
  }
  return "";
}

std::vector<std::string> term_names() {
  std::vector<std::string> result;
  for (const auto& entry : names) result.emplace_back(entry.second);
  return result;
}

TermKind term_kind(const std::string& name) {
  std::string list;
  for (const auto& [kind, known] : names) {
    if (name == known) return kind;
    list += (list.empty() ? "" : ", ") + std::string(known);
  }
  throw std::invalid_argument("\"" + name + "\" is not an objective term; the terms are " + list);
}

}  // namespace bodyline::model
