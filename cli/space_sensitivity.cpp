#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "cli/print_json.hpp"
#include "cli/space_rows.hpp"
#include "cli/space_views.hpp"
#include "explore/store_sensitivity.hpp"

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Request {
  std::string metric;
  std::size_t most = 20;
  bool json = false;
};

// Indices of factors, the most important first.
template <class Value>
std::vector<std::size_t> falling(std::size_t count, const Value& value) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return value(a) > value(b); });
  return order;
}

Json estimate_json(const explore::Estimate& estimate) {
  return {{"value", estimate.value}, {"half_width", estimate.half_width}};
}

Json morris_json(const explore::StoreSensitivity& found) {
  Json list = Json::array();
  for (std::size_t k = 0; k < found.factors.size(); ++k) {
    const explore::MorrisEffect& effect = found.morris->effects[k];
    list.push_back({{"factor", found.factors[k]},
                    {"mu_star", estimate_json(effect.mu_star)},
                    {"mu", effect.mu},
                    {"sigma", effect.sigma}});
  }
  return list;
}

Json sobol_json(const explore::StoreSensitivity& found) {
  Json list = Json::array();
  const std::size_t d = found.factors.size();
  for (std::size_t k = 0; k < d; ++k) {
    Json factor{{"factor", found.factors[k]},
                {"first", estimate_json(found.sobol->first[k])},
                {"total", estimate_json(found.sobol->total[k])}};
    for (std::size_t j = k + 1; j < d && !found.sobol->second.empty(); ++j)
      factor["second"][found.factors[j]] = estimate_json(found.sobol->second[k * d + j]);
    list.push_back(factor);
  }
  return list;
}

std::string morris_text(const explore::StoreSensitivity& found, std::size_t most) {
  const auto& effects = found.morris->effects;
  std::string text =
      fmt::format("{:>12} {:>10} {:>12} {:>12}  factor\n", "mu*", "+-", "mu", "sigma");
  for (const std::size_t k :
       falling(effects.size(), [&](std::size_t i) { return effects[i].mu_star.value; })) {
    if (most-- == 0) break;
    text += fmt::format("{:>12.5g} {:>10.3g} {:>12.5g} {:>12.5g}  {}\n", effects[k].mu_star.value,
                        effects[k].mu_star.half_width, effects[k].mu, effects[k].sigma,
                        found.factors[k]);
  }
  return text;
}

std::string sobol_text(const explore::StoreSensitivity& found, std::size_t most) {
  const explore::SobolIndices& indices = *found.sobol;
  std::string text = fmt::format("{:>8} {:>8} {:>8} {:>8}  factor\n", "total", "+-", "first", "+-");
  for (const std::size_t k :
       falling(found.factors.size(), [&](std::size_t i) { return indices.total[i].value; })) {
    if (most-- == 0) break;
    text += fmt::format("{:>8.4f} {:>8.4f} {:>8.4f} {:>8.4f}  {}\n", indices.total[k].value,
                        indices.total[k].half_width, indices.first[k].value,
                        indices.first[k].half_width, found.factors[k]);
  }
  return text;
}

void run(Context& context, const Request& request, const std::string& path) {
  const explore::StoreReader store(path);
  const std::string metric =
      request.metric.empty() ? store.study().metrics.front().name : request.metric;
  const explore::StoreSensitivity found = explore::store_sensitivity(store, metric);
  const std::size_t used = found.morris ? found.morris->used : found.sobol->used;
  const std::size_t all = found.morris ? found.morris->all : found.sobol->all;
  if (request.json) {
    print_json(context, {{"metric", metric},
                         {"design", found.morris ? "morris" : "saltelli"},
                         {"used", used},
                         {"of", all},
                         {"factors", found.morris ? morris_json(found) : sobol_json(found)}});
    return;
  }
  *context.out << fmt::format("{}, from {} of {} {}\n", metric, used, all,
                              found.morris ? "trajectories" : "base points")
               << (found.morris ? morris_text(found, request.most)
                                : sobol_text(found, request.most));
}

}  // namespace

void add_space_sensitivity(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_view(space, "sensitivity", "Which variables matter, from a Morris or Saltelli design",
               "bodyline space morris.h5 sensitivity bending");
  command->add_option("METRIC", request->metric, "The first one when left out")->type_name("");
  command->add_option("--first", request->most, "So many variables")
      ->type_name("N")
      ->check(CLI::Range(std::size_t(1), std::size_t(1'000'000)))
      ->capture_default_str();
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, store, &context] { run(context, *request, *store); });
}

}  // namespace bodyline::cli
