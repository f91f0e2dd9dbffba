#pragma once

#include <cstddef>
#include <vector>

#include "explore/store_layout.hpp"
#include "explore/study.hpp"

namespace bodyline::explore {

/// The bytes of a store without rows (docs/store.md), of a study with so many planned; `merged`
/// marks one for rows of several stores.
std::vector<std::byte> empty_store(const Study& study, const DesignSpace& space,
                                   std::uint64_t planned, bool merged);

}  // namespace bodyline::explore
