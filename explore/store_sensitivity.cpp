#include "explore/store_sensitivity.hpp"

#include <algorithm>
#include <stdexcept>

#include "explore/optimizer_kind.hpp"
#include "explore/sampler_kind.hpp"
#include "explore/sampler_sensitivity.hpp"
#include "explore/variant_filter.hpp"

namespace bodyline::explore {
namespace {

std::vector<double> column_values(const StoreReader& store, const StoreColumn& column) {
  std::vector<double> values;
  for_each_variant(store, VariantFilter(store, {}, {}), [&](const VariantRows& rows, int row) {
    values.push_back(column.of(rows, row));
  });
  return values;
}

// Coordinates of the cube: of a blend they are shares of what is left of its weights.
std::vector<std::string> factor_names(const DesignSpace& space) {
  std::vector<std::string> names;
  for (const Column& column : space.columns()) names.push_back(column.name);
  const bool blend = space.dimension() < space.column_count();
  if (!blend) return names;
  const auto last = std::find_if(space.columns().begin(), space.columns().end(),
                                 [](const Column& c) { return c.kind != ColumnKind::weight; });
  names.erase(names.begin() + (last - space.columns().begin()) - 1);
  return names;
}

}  // namespace

StoreSensitivity store_sensitivity(const StoreReader& store, const std::string& metric) {
  const StoreColumn column = store_column(store, metric);
  if (!column.is_metric) throw std::invalid_argument("'" + metric + "' is a variable, no metric");
  if (store.header().merged) {
    throw std::invalid_argument(
        "the store was put together from several; sensitivities come from each of them");
  }
  const SamplerSpec& sampler = store.study().sampler;
  if (store.study().optimizer) {
    throw std::invalid_argument("the store was made by the optimizer \"" +
                                optimizer_name(store.study().optimizer->kind) +
                                "\"; sensitivities come from the samplers morris and saltelli");
  }
  if (sampler.kind != SamplerKind::morris && sampler.kind != SamplerKind::saltelli) {
    throw std::invalid_argument("the store has the design \"" + sampler_name(sampler.kind) +
                                "\"; sensitivities come from \"morris\" or \"saltelli\"");
  }
  if (store.rows() < store.header().planned) {
    throw std::invalid_argument("the store is not complete: " + std::to_string(store.rows()) +
                                " of " + std::to_string(store.header().planned) + " variants");
  }
  const DesignSpace& space = store.space();
  const std::vector<double> results = column_values(store, column);
  StoreSensitivity found;
  found.factors = factor_names(space);
  if (sampler.kind == SamplerKind::saltelli) {
    found.sobol = sobol_indices(results, space.dimension(), sampler.second_order);
    return found;
  }
  const auto design =
      morris_sampler(space.dimension(), sampler.trajectories, sampler.levels, sampler.seed);
  std::vector<double> points(results.size() * std::size_t(space.dimension()));
  design->points(0, int(results.size()), points);
  found.morris = morris_effects(points, results, space.dimension());
  return found;
}

}  // namespace bodyline::explore
