#include "explore/browse_rows.hpp"

#include <algorithm>
#include <stdexcept>

#include "explore/pareto.hpp"

namespace bodyline::explore {
namespace {

bool should_be_small(MetricKind kind) {
  using enum MetricKind;
  constexpr MetricKind costs[] = {bending, variation, fold, closeness,   folds,
                                  kink,    gap,       scan, frontal_area};
  return std::find(std::begin(costs), std::end(costs), kind) != std::end(costs);
}

std::vector<BrowseObjective> usual_objectives(const Study& study) {
  constexpr std::size_t usual = 2;
  std::vector<BrowseObjective> objectives;
  for (const bool cost : {true, false}) {
    for (int k = 0; k < int(study.metrics.size()) && objectives.size() < usual; ++k) {
      if (should_be_small(study.metrics[k].kind) == cost) objectives.push_back({{true, k}, true});
    }
  }
  return objectives;
}

std::vector<std::uint64_t> pareto_ids(const StoreReader& store,
                                      const std::vector<BrowseObjective>& objectives) {
  if (objectives.size() < 2) return {};
  std::vector<std::uint64_t> ids;
  std::vector<double> values;
  for_each_variant(store, VariantFilter(store, {}, {status_name(VariantStatus::valid)}),
                   [&](const VariantRows& rows, int row) {
                     ids.push_back(rows.first + std::uint64_t(row));
                     for (const BrowseObjective& objective : objectives) {
                       const double value = objective.column.of(rows, row);
                       values.push_back(objective.minimize ? value : -value);
                     }
                   });
  std::vector<std::uint64_t> front;
  for (const std::size_t k : pareto_set(values, int(objectives.size()))) front.push_back(ids[k]);
  return front;
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

std::vector<BrowseObjective> browse_objectives(const StoreReader& store,
                                               const std::vector<std::string>& minimize,
                                               const std::vector<std::string>& maximize) {
  if (minimize.empty() && maximize.empty()) return usual_objectives(store.study());
  std::vector<BrowseObjective> objectives;
  for (const std::string& name : minimize) objectives.push_back({store_column(store, name), true});
  for (const std::string& name : maximize) objectives.push_back({store_column(store, name), false});
  if (objectives.size() < 2)
    throw std::invalid_argument("give two objectives or more with --minimize and --maximize");
  return objectives;
}

BrowseRows browse_rows(const StoreReader& store, const std::vector<BrowseObjective>& objectives,
                       int limit) {
  const std::vector<std::uint64_t> front = pareto_ids(store, objectives);
  BrowseRows shown;
  shown.ids = sampled_ids(store.rows(), front, std::min(store.rows(), std::uint64_t(limit)));
  shown.columns.resize(std::size_t(store.space().column_count()) + store.study().metrics.size());
  std::size_t next = 0;
  for_each_variant(store, VariantFilter(store, {}, {}), [&](const VariantRows& rows, int row) {
    if (next == shown.ids.size() || rows.first + std::uint64_t(row) != shown.ids[next]) return;
    append_row(shown, rows, row);
    ++next;
  });
  for (const std::uint64_t id : front) {
    const auto at = std::lower_bound(shown.ids.begin(), shown.ids.end(), id);
    shown.pareto.push_back(int(at - shown.ids.begin()));
  }
  return shown;
}

}  // namespace bodyline::explore
