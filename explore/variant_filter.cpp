#include "explore/variant_filter.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "model/suggest.hpp"

namespace bodyline::explore {
namespace {

double number_of(const std::string& text, const std::string& condition) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || std::isnan(number))
    throw std::invalid_argument("'" + condition + "' compares with '" + text + "', no number");
  return number;
}

}  // namespace

double StoreColumn::of(const VariantRows& rows, int row) const {
  const std::vector<double>& table = is_metric ? rows.metrics : rows.values;
  const std::size_t width = table.size() / std::size_t(rows.count);
  return table[std::size_t(row) * width + std::size_t(index)];
}

std::vector<std::string> variable_names(const StoreReader& store) {
  std::vector<std::string> names;
  for (const Column& column : store.space().columns()) names.push_back(column.name);
  return names;
}

std::vector<std::string> metric_names(const StoreReader& store) {
  std::vector<std::string> names;
  for (const MetricSpec& metric : store.study().metrics) names.push_back(metric.name);
  return names;
}

StoreColumn store_column(const StoreReader& store, const std::string& name) {
  std::vector<std::string> all;
  for (const bool is_metric : {true, false}) {
    const std::vector<std::string> names = is_metric ? metric_names(store) : variable_names(store);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return {is_metric, int(found - names.begin())};
    all.insert(all.end(), names.begin(), names.end());
  }
  throw std::invalid_argument("the store has no column '" + name + "'; the nearest is '" +
                              model::nearest_name(name, all) + "'");
}

VariantStatus status_of(const std::string& name) {
  std::string list;
  for (int k = 0; k < status_count; ++k) {
    const std::string known = status_name(VariantStatus(k));
    if (name == known) return VariantStatus(k);
    list += (list.empty() ? "" : ", ") + known;
  }
  throw std::invalid_argument("'" + name + "' is no status; there are " + list);
}

VariantFilter::VariantFilter(const StoreReader& store, const std::vector<std::string>& conditions,
                             const std::vector<std::string>& statuses) {
  for (const std::string& condition : conditions) {
    const std::size_t at = condition.find_first_of("<>");
    if (at == std::string::npos || at == 0 || condition[at + 1] != '=')
      throw std::invalid_argument("'" + condition +
                                  "' is no condition: give NAME<=NUMBER or NAME>=NUMBER");
    conditions_.push_back({store_column(store, condition.substr(0, at)), condition[at] == '<',
                           number_of(condition.substr(at + 2), condition)});
  }
  for (const std::string& status : statuses) statuses_.push_back(status_of(status));
}

bool VariantFilter::takes(const VariantRows& rows, int row) const {
  const VariantStatus status{rows.status[row]};
  if (!statuses_.empty() &&
      std::find(statuses_.begin(), statuses_.end(), status) == statuses_.end())
    return false;
  return std::all_of(conditions_.begin(), conditions_.end(), [&](const Condition& condition) {
    const double value = condition.column.of(rows, row);
    return condition.at_most ? value <= condition.limit : value >= condition.limit;
  });
}

}  // namespace bodyline::explore
