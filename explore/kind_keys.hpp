#pragma once

#include <set>
#include <span>
#include <string>

#include "io/model_file_table.hpp"

namespace bodyline::explore {

/// The keys that a kind of sampler or optimizer needs, and those that it may have.
struct KindKeys {
  std::set<std::string> needed, allowed;
};

/// Fails at the first key of `all` that is needed and missing, or that is there and neither needed
/// nor allowed. `kind` says whose keys they are, as "sampler sobol".
void check_kind_keys(const io::FileTable& table, const KindKeys& keys,
                     std::span<const char* const> all, const std::string& kind);

}  // namespace bodyline::explore
