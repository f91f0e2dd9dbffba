#pragma once

#include <string>

#include "explore/browse_bodies.hpp"
#include "explore/browse_rows.hpp"

namespace bodyline::explore {

/// What a page knows beside its numbers: the study, names, units and limits of the columns, causes,
/// faces of the bodies. JSON that may stand within a <script> element.
std::string browse_description(const StoreReader& store,
                               const std::vector<StoreObjective>& objectives,
                               const BrowseRows& rows, const BrowseBodies& bodies);

}  // namespace bodyline::explore
