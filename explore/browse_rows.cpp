#include "explore/browse_rows.hpp"

#include <algorithm>

namespace bodyline::explore {
namespace {

bool should_be_small(MetricKind kind) {
  switch (kind) {
    case MetricKind::bending:
    case MetricKind::variation:
    case MetricKind::fold:
    case MetricKind::closeness:
    case MetricKind::frontal_area:
    case MetricKind::folds:
    case MetricKind::kink:
    case MetricKind::gap:
    case MetricKind::scan:
    case MetricKind::outline:
      return true;
    case MetricKind::area:
    case MetricKind::length:
    case MetricKind::width:
    case MetricKind::height:
    case MetricKind::wheelbase:
    case MetricKind::front_overhang:
    case MetricKind::rear_overhang:
    case MetricKind::rake:
    case MetricKind::volume:
      return false;
  }
  return false;
}

std::vector<StoreObjective> usual_objectives(const Study& study) {
  constexpr std::size_t usual = 2;
  std::vector<StoreObjective> objectives;
  for (const bool cost : {true, false}) {
    for (int k = 0; k < int(study.metrics.size()) && objectives.size() < usual; ++k) {
      if (should_be_small(study.metrics[k].kind) == cost) objectives.push_back({{true, k}, true});
    }
  }
  return objectives;
}

// `kept` (rising) and as many other rows as make up `limit`: of the others, in their order, the
// middles of equal parts.
std::vector<std::uint64_t> sampled_ids(std::uint64_t rows, const std::vector<std::uint64_t>& kept,
                                       std::uint64_t limit) {
  const std::uint64_t others = rows - kept.size();
  const std::uint64_t wanted =
      std::min(others, limit - std::min<std::uint64_t>(limit, kept.size()));
  std::vector<std::uint64_t> ids = kept;
  std::size_t passed = 0;  // of `kept`
  for (std::uint64_t k = 0; k < wanted; ++k) {
    const auto place = std::uint64_t((double(k) + 0.5) * double(others) / double(wanted));
    while (passed < kept.size() && kept[passed] <= place + passed) ++passed;
    ids.push_back(place + passed);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

void append_row(BrowseRows& shown, const VariantRows& rows, int row) {
  shown.status.push_back(rows.status[row]);
  shown.cause.push_back(rows.cause[row]);
  const std::size_t variables = rows.values.size() / std::size_t(rows.count);
  const std::size_t metrics = rows.metrics.size() / std::size_t(rows.count);
  for (std::size_t k = 0; k < variables; ++k)
    shown.columns[k].push_back(rows.values[std::size_t(row) * variables + k]);
  for (std::size_t k = 0; k < metrics; ++k)
    shown.columns[variables + k].push_back(rows.metrics[std::size_t(row) * metrics + k]);
}

}  // namespace

std::vector<StoreObjective> browse_objectives(const StoreReader& store,
                                              const std::vector<std::string>& minimize,
                                              const std::vector<std::string>& maximize) {
  if (minimize.empty() && maximize.empty()) return usual_objectives(store.study());
  return store_objectives(store, minimize, maximize);
}

BrowseRows browse_rows(const StoreReader& store, const std::vector<StoreObjective>& objectives,
                       int limit) {
  std::vector<std::uint64_t> front;
  if (objectives.size() >= 2)
    front = pareto_ids(store, VariantFilter(store, {}, {status_name(VariantStatus::valid)}),
                       objectives);
  BrowseRows shown;
  shown.ids = sampled_ids(store.rows(), front, std::min(store.rows(), std::uint64_t(limit)));
  shown.columns.resize(std::size_t(store.space().column_count()) + store.study().metrics.size());
  constexpr std::uint64_t at_once = 4096;
  VariantRows rows;
  for (const std::uint64_t id : shown.ids) {
    if (id >= rows.first + std::uint64_t(rows.count)) {
      const std::uint64_t first = id / at_once * at_once;
      rows = store.read(first, int(std::min(at_once, store.rows() - first)));
    }
    append_row(shown, rows, int(id - rows.first));
  }
  for (const std::uint64_t id : front) {
    const auto at = std::lower_bound(shown.ids.begin(), shown.ids.end(), id);
    shown.pareto.push_back(int(at - shown.ids.begin()));
  }
  return shown;
}

}  // namespace bodyline::explore
