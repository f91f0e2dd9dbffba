#include "model/hard_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bodyline::model {
namespace {

constexpr std::array<std::string_view, 3> rule_names{"through", "inside", "outside"};

}  // namespace

std::string rule_name(HardPointRule rule) { return std::string(rule_names[std::size_t(rule)]); }

std::optional<HardPointRule> rule_from_name(std::string_view name) {
  const auto at = std::find(rule_names.begin(), rule_names.end(), name);
  if (at == rule_names.end()) return std::nullopt;
  return HardPointRule(at - rule_names.begin());
}

double breach(const HardPoint& point, double distance) {
  if (std::isnan(distance)) return distance;
  switch (point.rule) {
    case HardPointRule::inside:
      return std::max(0.0, distance + point.margin);
    case HardPointRule::outside:
      return std::max(0.0, point.margin - distance);
    case HardPointRule::through:
      break;
  }
  return std::abs(distance);
}

}  // namespace bodyline::model
