#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/space_views.hpp"

namespace bodyline::cli {

/// Columns of a store that should be small or large.
struct Objectives {
  std::vector<std::string> minimize, maximize;
};

/// Where none are given: the goals of the optimizer that made a store.
void take_goals(const explore::StoreReader& store, Objectives& objectives);

/// Adds --minimize and --maximize.
void add_objectives(CLI::App& command, Objectives& objectives);

/// The variants, of those chosen or of the valid ones, that no other is better than. Throws
/// std::invalid_argument for fewer than two objectives and for unknown names.
std::vector<std::uint64_t> pareto_ids(const explore::StoreReader& store, VariantChoice choice,
                                      const Objectives& objectives);

}  // namespace bodyline::cli
