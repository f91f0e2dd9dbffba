#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "explore/store_reader.hpp"

/// The commands under `bodyline space STORE`, each of which looks at variants in its way.
namespace bodyline::cli {

/// The store that all of them look at, named before the command.
using StorePath = std::shared_ptr<std::string>;

/// Which variants a command takes.
struct VariantChoice {
  std::vector<std::string> where, status;
};

/// Adds --where and --status.
void add_variant_choice(CLI::App& command, VariantChoice& choice);

/// Adds a command under `space`.
CLI::App* add_view(CLI::App& space, const std::string& name, const std::string& purpose,
                   const std::string& example);

void add_space_list(CLI::App& space, Context& context, const StorePath& store);
void add_space_show(CLI::App& space, Context& context, const StorePath& store);
void add_space_model(CLI::App& space, Context& context, const StorePath& store);
void add_space_table(CLI::App& space, Context& context, const StorePath& store);
void add_space_pareto(CLI::App& space, Context& context, const StorePath& store);
void add_space_plot(CLI::App& space, Context& context, const StorePath& store);
void add_space_sensitivity(CLI::App& space, Context& context, const StorePath& store);
void add_space_merge(CLI::App& space, Context& context, const StorePath& store);

}  // namespace bodyline::cli
