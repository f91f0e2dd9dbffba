#include "cli/space_command.hpp"

#include <memory>
#include <string>

#include "cli/space_views.hpp"

namespace bodyline::cli {

void add_variant_choice(CLI::App& command, VariantChoice& choice) {
  command
      .add_option("--where", choice.where,
                  "Only variants with NAME<=NUMBER or NAME>=NUMBER; several by repeating")
      ->type_name("CONDITION")
      ->allow_extra_args(false)
      ->take_all();
  command
      .add_option("--status", choice.status,
                  "Only variants of this status (valid, infeasible, folded, ...); several by "
                  "commas")
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->take_all();
}

CLI::App* add_view(CLI::App& space, const std::string& name, const std::string& purpose,
                   const std::string& example) {
  CLI::App* const command = space.add_subcommand(name, purpose);
  command->fallthrough();
  command->footer("Example:\n  " + example);
  return command;
}

void add_space_command(CLI::App& program, Context& context) {
  const auto store = std::make_shared<std::string>();
  CLI::App* const space = add_command(program, "space", "Look into a store of variants",
                                      "bodyline space sweep.h5 list --sort bending");
  space->add_option("STORE", *store, "Store of variants (.h5)")->required()->type_name("");
  space->require_subcommand(1);
  // Its own: the other commands share one.
  space->formatter(std::make_shared<CLI::Formatter>());
  space->get_formatter()->label("SUBCOMMAND", "VIEW");
  add_space_list(*space, context, store);
  add_space_show(*space, context, store);
  add_space_model(*space, context, store);
  add_space_table(*space, context, store);
  add_space_pareto(*space, context, store);
  add_space_plot(*space, context, store);
  add_space_sensitivity(*space, context, store);
  add_space_merge(*space, context, store);
}

}  // namespace bodyline::cli
