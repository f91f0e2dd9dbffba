#include "explore/browse_rows.hpp"

#include <algorithm>
#include <stdexcept>

#include "explore/pareto.hpp"

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

// Variants with their objectives, all to be small; those that others are better than are dropped
// from time to time, so that memory follows the front.
class Front {
 public:
  explicit Front(std::size_t objectives) : objectives_(objectives) {}

  void add(std::uint64_t id, const std::vector<double>& costs) {
    ids_.push_back(id);
    costs_.insert(costs_.end(), costs.begin(), costs.end());
    if (ids_.size() < most_) return;
    reduce();
    most_ = std::max(least_most, 2 * ids_.size());
  }

  std::vector<std::uint64_t> ids() {
    reduce();
    return ids_;
  }

 private:
  static constexpr std::size_t least_most = std::size_t(1) << 16;

  void reduce() {
    const std::vector<std::size_t> front = pareto_set(costs_, int(objectives_));
    for (std::size_t k = 0; k < front.size(); ++k) {
      ids_[k] = ids_[front[k]];
      std::copy_n(costs_.begin() + front[k] * objectives_, objectives_,
                  costs_.begin() + k * objectives_);
    }
    ids_.resize(front.size());
    costs_.resize(front.size() * objectives_);
  }

  std::size_t objectives_, most_ = least_most;
  std::vector<std::uint64_t> ids_;
  std::vector<double> costs_;
};

std::vector<std::uint64_t> pareto_ids(const StoreReader& store,
                                      const std::vector<BrowseObjective>& objectives) {
  if (objectives.size() < 2) return {};
  Front front(objectives.size());
  std::vector<double> costs(objectives.size());
  for_each_variant(store, VariantFilter(store, {}, {status_name(VariantStatus::valid)}),
                   [&](const VariantRows& rows, int row) {
                     for (std::size_t k = 0; k < costs.size(); ++k) {
                       const double value = objectives[k].column.of(rows, row);
                       costs[k] = objectives[k].minimize ? value : -value;
                     }
                     front.add(rows.first + std::uint64_t(row), costs);
                   });
  return front.ids();
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
