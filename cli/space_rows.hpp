#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "explore/variant_filter.hpp"

/// Variants of a store, as commands tell of them.
namespace bodyline::cli {

/// A table of variants with status and metrics, one line each.
std::string variants_text(const explore::StoreReader& store, const std::vector<std::uint64_t>& ids);

/// Each with "id", "status", "cause" and "metrics".
nlohmann::ordered_json variants_json(const explore::StoreReader& store,
                                     const std::vector<std::uint64_t>& ids);

/// The same of one variant, and its "variables".
nlohmann::ordered_json variant_json(const explore::StoreReader& store, std::uint64_t id);

/// Throws std::invalid_argument when the store has no such variant.
void check_id(const explore::StoreReader& store, std::uint64_t id);

}  // namespace bodyline::cli
