#include "cli/space_pareto.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/print_json.hpp"
#include "cli/space_rows.hpp"
#include "explore/pareto.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  VariantChoice choice;
  Objectives objectives;
  bool json = false;
};

void run(Context& context, Request& request, const std::string& path) {
  const explore::StoreReader store(path);
  const std::vector<std::uint64_t> ids = pareto_ids(store, request.choice, request.objectives);
  if (request.json) {
    print_json(context, {{"store", path}, {"variants", variants_json(store, ids)}});
  } else {
    *context.out << variants_text(store, ids)
                 << fmt::format("{} variants that no other is better than\n", ids.size());
  }
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

std::vector<std::uint64_t> pareto_ids(const explore::StoreReader& store, VariantChoice choice,
                                      const Objectives& objectives) {
  if (choice.status.empty()) choice.status = {"valid"};
  std::vector<explore::StoreColumn> columns;
  std::vector<double> signs;
  for (const std::string& name : objectives.minimize) {
    columns.push_back(explore::store_column(store, name));
    signs.push_back(1.0);
  }
  for (const std::string& name : objectives.maximize) {
    columns.push_back(explore::store_column(store, name));
    signs.push_back(-1.0);
  }
  if (columns.size() < 2)
    throw std::invalid_argument("give two objectives or more with --minimize and --maximize");
  std::vector<std::uint64_t> ids;
  std::vector<double> values;
  const explore::VariantFilter filter(store, choice.where, choice.status);
  explore::for_each_variant(store, filter, [&](const explore::VariantRows& rows, int row) {
    ids.push_back(rows.first + std::uint64_t(row));
    for (std::size_t k = 0; k < columns.size(); ++k)
      values.push_back(signs[k] * columns[k].of(rows, row));
  });
  std::vector<std::uint64_t> front;
  for (const std::size_t k : explore::pareto_set(values, int(columns.size())))
    front.push_back(ids[k]);
  return front;
}

void add_space_pareto(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_view(space, "pareto", "List the variants that no other is better than",
               "bodyline space sweep.h5 pareto --minimize bending,height --maximize length");
  add_variant_choice(*command, request->choice);
  add_objectives(*command, request->objectives);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, store, &context] { run(context, *request, *store); });
}

}  // namespace bodyline::cli
