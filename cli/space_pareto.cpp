#include "cli/space_pareto.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "cli/print_json.hpp"
#include "cli/space_rows.hpp"
#include "explore/hypervolume.hpp"
#include "explore/pareto_rows.hpp"

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;

// Of each variant, all to be small.
std::vector<double> objective_values(const explore::StoreReader& store,
                                     const std::vector<std::uint64_t>& ids,
                                     const std::vector<explore::StoreObjective>& objectives) {
  std::vector<double> values;
  for (const std::uint64_t id : ids) {
    const explore::VariantRows rows = store.read(id, 1);
    for (const explore::StoreObjective& objective : objectives)
      values.push_back(objective.cost(rows, 0));
  }
  return values;
}

struct Request {
  VariantChoice choice;
  Objectives objectives;
  std::vector<double> reference;
  bool json = false;
};

// The reference that was given, or the worst of the front in each objective.
std::vector<double> reference_of(const Request& request, const std::vector<double>& values,
                                 std::size_t objectives) {
  if (!request.reference.empty() && request.reference.size() != objectives) {
    throw std::invalid_argument(
        fmt::format("--reference needs {} numbers, one for each objective", objectives));
  }
  std::vector<double> reference(objectives, -std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < values.size(); ++k)
    reference[k % objectives] = std::max(reference[k % objectives], values[k]);
  for (std::size_t k = 0; k < request.reference.size(); ++k) {
    const bool largest = k >= request.objectives.minimize.size();
    reference[k] = largest ? -request.reference[k] : request.reference[k];
  }
  return reference;
}

// Of more than three objectives it takes very long for many points, and must be asked for.
std::optional<double> volume_to(const std::vector<double>& reference,
                                const std::vector<double>& values, const Request& request) {
  if (values.empty() || (reference.size() > 3 && request.reference.empty())) return std::nullopt;
  return explore::hypervolume(values, reference);
}

void run(Context& context, Request& request, const std::string& path) {
  const explore::StoreReader store(path);
  take_goals(store, request.objectives);
  const std::vector<std::uint64_t> ids = pareto_ids(store, request.choice, request.objectives);
  const std::vector<double> values = objective_values(
      store, ids,
      store_objectives(store, request.objectives.minimize, request.objectives.maximize));
  const std::size_t least = request.objectives.minimize.size(),
                    count = least + request.objectives.maximize.size();
  std::vector<double> reference = reference_of(request, values, count);
  const std::optional<double> volume = volume_to(reference, values, request);
  for (std::size_t k = least; k < count; ++k) reference[k] = -reference[k];
  if (request.json) {
    Json json{{"store", path}, {"hypervolume", nullptr}};
    if (volume) json["hypervolume"] = *volume;
    json["reference"] = reference;
    json["variants"] = variants_json(store, ids);
    print_json(context, json);
    return;
  }
  *context.out << variants_text(store, ids)
               << fmt::format("{} variants that no other is better than", ids.size());
  if (volume)
    *context.out << fmt::format(", hypervolume {:.6g} to ({:.6g})", *volume,
                                fmt::join(reference, ", "));
  *context.out << "\n";
}

}  // namespace

void add_objectives(CLI::App& command, Objectives& objectives) {
  const auto add = [&](const char* flag, std::vector<std::string>& names, const char* text) {
    command.add_option(flag, names, text)
        ->type_name("NAME")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all();
  };
  add("--minimize", objectives.minimize, "Metrics or variables that should be small, by commas");
  add("--maximize", objectives.maximize, "Those that should be large");
}

void take_goals(const explore::StoreReader& store, Objectives& objectives) {
  if (!objectives.minimize.empty() || !objectives.maximize.empty()) return;
  if (!store.study().optimizer) return;
  for (const explore::Goal& goal : store.study().optimizer->goals)
    (goal.weight > 0.0 ? objectives.minimize : objectives.maximize).push_back(goal.metric);
}

std::vector<std::uint64_t> pareto_ids(const explore::StoreReader& store, VariantChoice choice,
                                      const Objectives& objectives) {
  if (choice.status.empty()) choice.status = {"valid"};
  return explore::pareto_ids(
      store, explore::VariantFilter(store, choice.where, choice.status),
      explore::store_objectives(store, objectives.minimize, objectives.maximize));
}

void add_space_pareto(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_view(space, "pareto", "List the variants that no other is better than",
               "bodyline space sweep.h5 pareto --minimize bending,height --maximize length");
  add_variant_choice(*command, request->choice);
  add_objectives(*command, request->objectives);
  command
      ->add_option("--reference", request->reference,
                   "What the hypervolume is measured to: numbers in the order of the "
                   "objectives, by commas; the worst of the front when left out")
      ->type_name("X,Y")
      ->delimiter(',');
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, store, &context] { run(context, *request, *store); });
}

}  // namespace bodyline::cli
