#include <array>
#include <set>
#include <stdexcept>
#include <string>

#include "explore/kind_keys.hpp"
#include "explore/optimizer_kind.hpp"
#include "explore/study_tables.hpp"
#include "io/model_file_lookup.hpp"

namespace bodyline::explore {
namespace {

using io::FileTable;

constexpr std::int64_t largest_population = 5000, most_generations = 1'000'000;
constexpr std::int64_t most_points = 100'000, most_evaluations = 1'000'000;
constexpr std::int64_t least_population = 8;
constexpr std::size_t most_objectives = 20;
constexpr double largest_weight = 1e12;
constexpr int local_evaluations = 200, front_evaluations = 25;

KindKeys keys_of(OptimizerKind kind) {
  switch (kind) {
    case OptimizerKind::local:
      return {{"starts"}, {"weights", "algorithm", "evaluations"}};
    case OptimizerKind::nsga2:
    case OptimizerKind::moead:
      return {{"population", "generations"}, {"seed"}};
    case OptimizerKind::front:
      return {{"points"}, {"evaluations"}};
  }
  return {};
}

constexpr std::array keys_of_optimizers{"starts",     "weights",     "algorithm", "evaluations",
                                        "population", "generations", "seed",      "points"};

void read_goals(const FileTable& table, const Study& study, OptimizerSpec& optimizer) {
  std::set<std::string> named;
  for (const char* key : {"minimize", "maximize"}) {
    if (!table.has(key)) continue;
    for (const std::string& metric : table.texts(key, {1, most_objectives})) {
      io::index_of(study.metrics, metric, table, key, "metric");
      if (!named.insert(metric).second)
        table.fail(key, "names " + io::in_quotes(metric) + " twice.");
      optimizer.goals.push_back({metric, std::string(key) == "minimize" ? 1.0 : -1.0});
    }
  }
  if (optimizer.goals.empty())
    table.fail("minimize", "is missing, and \"maximize\" too; an optimizer needs a metric.");
  if (!table.has("weights")) return;
  const std::size_t count = optimizer.goals.size();
  const std::vector<double> weights = table.numbers("weights", {count, count}, largest_weight);
  for (std::size_t k = 0; k < count; ++k) {
    if (!(weights[k] > 0.0)) table.fail("weights", "must all be above 0.");
    optimizer.goals[k].weight *= weights[k];
  }
}

void check_goal_count(const FileTable& table, const OptimizerSpec& optimizer) {
  const std::size_t count = optimizer.goals.size();
  if (optimizer.kind == OptimizerKind::front && count != 2) {
    table.fail("minimize", "and \"maximize\" name " + std::to_string(count) +
                               " metrics; a front by gradients is one of two (nsga2 and moead "
                               "take more).");
  }
  if (optimizer.kind != OptimizerKind::local && count < 2)
    table.fail("minimize", "and \"maximize\" name one metric; a front needs two or more.");
}

optimize::Algorithm algorithm_of(const FileTable& table, const Study& study) {
  const bool constrained = !study.constraints.empty();
  if (!table.has("algorithm"))
    return constrained ? optimize::Algorithm::nlopt_ccsaq : optimize::Algorithm::nlopt_lbfgs;
  try {
    return optimize::algorithm_from_name(table.text("algorithm"));
  } catch (const std::invalid_argument& error) {
    table.fail("algorithm", error.what());
  }
}

// The points that an optimizer without starts of its own begins with.
SamplerSpec first_points(const OptimizerSpec& optimizer) {
  SamplerSpec sampler;
  sampler.kind = optimizer.kind == OptimizerKind::front ? SamplerKind::random : SamplerKind::sobol;
  sampler.count = planned_rows(optimizer, 0);
  sampler.seed = optimizer.seed;
  return sampler;
}

void read_optimizer(const FileTable& table, Study& study) {
  table.allow_only({"kind", "minimize", "maximize", "weights", "starts", "algorithm", "evaluations",
                    "population", "generations", "seed", "points"},
                   "an optimizer");
  OptimizerSpec optimizer;
  try {
    optimizer.kind = optimizer_kind(table.text("kind"));
  } catch (const std::invalid_argument& error) {
    table.fail("kind", std::string(error.what()) + ".");
  }
  check_kind_keys(table, keys_of(optimizer.kind), keys_of_optimizers,
                  "optimizer " + optimizer_name(optimizer.kind));
  read_goals(table, study, optimizer);
  check_goal_count(table, optimizer);
  const auto whole = [&](const char* key, std::int64_t least, std::int64_t most,
                         std::int64_t otherwise) {
    return table.has(key) ? table.whole(key, least, most) : otherwise;
  };
  optimizer.seed = std::uint64_t(whole("seed", 0, std::numeric_limits<std::uint32_t>::max(), 1));
  optimizer.population = int(whole("population", least_population, largest_population, 0));
  optimizer.generations = int(whole("generations", 1, most_generations, 0));
  optimizer.points = int(whole("points", 3, most_points, 0));
  const bool local = optimizer.kind == OptimizerKind::local;
  optimizer.evaluations =
      int(whole("evaluations", 2, most_evaluations, local ? local_evaluations : front_evaluations));
  optimizer.algorithm = algorithm_of(table, study);
  if (optimizer.kind == OptimizerKind::nsga2 && optimizer.population % 4 != 0)
    table.fail("population", "must be a multiple of 4 for nsga2.");
  study.sampler = local ? read_sampler(*table.find_table("starts")) : first_points(optimizer);
  study.optimizer = optimizer;
}

}  // namespace

void read_choice_of_variants(const FileTable& root, Study& study) {
  const auto sampler = root.find_table("sampler"), optimizer = root.find_table("optimizer");
  if (sampler && optimizer)
    root.fail("optimizer",
              "and \"sampler\" exclude each other; starts of an optimizer are its own.");
  if (!sampler && !optimizer)
    root.fail("sampler",
              "is missing, and \"optimizer\" too; one says which variants are measured.");
  if (sampler) study.sampler = read_sampler(*sampler);
  if (optimizer) read_optimizer(*optimizer, study);
}

}  // namespace bodyline::explore
