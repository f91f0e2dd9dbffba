#include "explore/pareto_rows.hpp"

#include <algorithm>
#include <stdexcept>

#include "explore/pareto.hpp"

namespace bodyline::explore {
namespace {

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

}  // namespace

std::vector<StoreObjective> store_objectives(const StoreReader& store,
                                             const std::vector<std::string>& minimize,
                                             const std::vector<std::string>& maximize) {
  std::vector<StoreObjective> objectives;
  for (const std::string& name : minimize) objectives.push_back({store_column(store, name), true});
  for (const std::string& name : maximize) objectives.push_back({store_column(store, name), false});
  if (objectives.size() < 2)
    throw std::invalid_argument("give two objectives or more with --minimize and --maximize");
  return objectives;
}

std::vector<std::uint64_t> pareto_ids(const StoreReader& store, const VariantFilter& filter,
                                      const std::vector<StoreObjective>& objectives) {
  Front front(objectives.size());
  std::vector<double> costs(objectives.size());
  for_each_variant(store, filter, [&](const VariantRows& rows, int row) {
    for (std::size_t k = 0; k < costs.size(); ++k) costs[k] = objectives[k].cost(rows, row);
    front.add(rows.first + std::uint64_t(row), costs);
  });
  return front.ids();
}

}  // namespace bodyline::explore
