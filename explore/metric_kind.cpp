#include "explore/metric_kind.hpp"

#include <array>
#include <stdexcept>

namespace bodyline::explore {
namespace {

struct MetricFacts {
  MetricKind kind;
  const char* name;
  const char* unit;
};

constexpr std::array<MetricFacts, 19> facts{{{MetricKind::bending, "bending", "1"},
                                             {MetricKind::variation, "variation", "1"},
                                             {MetricKind::area, "area", "m2"},
                                             {MetricKind::fold, "fold", "1"},
                                             {MetricKind::closeness, "closeness", "mm2"},
                                             {MetricKind::length, "length", "mm"},
                                             {MetricKind::width, "width", "mm"},
                                             {MetricKind::height, "height", "mm"},
                                             {MetricKind::wheelbase, "wheelbase", "mm"},
                                             {MetricKind::front_overhang, "front_overhang", "mm"},
                                             {MetricKind::rear_overhang, "rear_overhang", "mm"},
                                             {MetricKind::rake, "rake", "deg"},
                                             {MetricKind::frontal_area, "frontal_area", "m2"},
                                             {MetricKind::volume, "volume", "m3"},
                                             {MetricKind::folds, "folds", "1"},
                                             {MetricKind::kink, "kink", "deg"},
                                             {MetricKind::gap, "gap", "mm"},
                                             {MetricKind::scan, "scan", "mm"},
                                             {MetricKind::outline, "outline", "mm"}}};

}  // namespace

std::string metric_name(MetricKind kind) { return facts[std::size_t(kind)].name; }

std::string metric_unit(MetricKind kind) { return facts[std::size_t(kind)].unit; }

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const MetricFacts& fact : facts) names.emplace_back(fact.name);
  return names;
}

MetricKind metric_kind(const std::string& name) {
  std::string list;
  for (const MetricFacts& fact : facts) {
    if (name == fact.name) return fact.kind;
    list += (list.empty() ? "" : ", ") + std::string(fact.name);
  }
  throw std::invalid_argument("\"" + name + "\" is not a metric; the metrics are " + list);
}

bool is_term(MetricKind kind) { return kind <= MetricKind::closeness; }

}  // namespace bodyline::explore
