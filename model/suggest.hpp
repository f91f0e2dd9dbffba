#pragma once

#include <string>
#include <vector>

namespace bodyline::model {

/// The candidate with the smallest edit distance to `name`; empty when there are none.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace bodyline::model
