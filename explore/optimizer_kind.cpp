#include "explore/optimizer_kind.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace bodyline::explore {
namespace {

constexpr std::array<std::pair<OptimizerKind, const char*>, 4> names{
    {{OptimizerKind::local, "local"},
     {OptimizerKind::nsga2, "nsga2"},
     {OptimizerKind::moead, "moead"},
     {OptimizerKind::front, "front"}}};

}  // namespace

std::string optimizer_name(OptimizerKind kind) { return names[std::size_t(kind)].second; }

OptimizerKind optimizer_kind(const std::string& name) {
  std::string list;
  for (const auto& [kind, known] : names) {
    if (name == known) return kind;
    list += (list.empty() ? "" : ", ") + std::string(known);
  }
  throw std::invalid_argument("\"" + name + "\" is not an optimizer; the optimizers are " + list);
}

bool uses_gradients(OptimizerKind kind) {
  return kind == OptimizerKind::local || kind == OptimizerKind::front;
}

std::uint64_t planned_rows(const OptimizerSpec& optimizer, std::uint64_t starts) {
  switch (optimizer.kind) {
    case OptimizerKind::local:
      return starts;
    case OptimizerKind::nsga2:
    case OptimizerKind::moead:
      return std::uint64_t(optimizer.population) * std::uint64_t(optimizer.generations + 1);
    case OptimizerKind::front:
      return std::uint64_t(optimizer.points);
  }
  return 0;
}

}  // namespace bodyline::explore
